#include "widgets/tube_cores/tube_core_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <utility>

#include "processing/explanation/explanation_plots.h"
#include "widgets/controls/disclosure.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/fitted_table.h"
#include "widgets/plots/plot_canvas.h"
#include "widgets/tube_cores/reading_parameters.h"
#include "widgets/tube_cores/tube_core_list.h"
#include "widgets/tube_cores/tube_core_map.h"

namespace echolucent {

namespace {

constexpr int plotHeight = 120, curvesHeight = 150, changeHeight = 80;  // pixels

QLabel* createText(const QString& name, const QString& accessibleName) {
    auto* label = named(new QLabel, name, accessibleName);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QString toolTipOf(const ExplanationFact& fact) {
    QStringList lines{QString::fromStdString(fact.meaning)};
    if (!fact.equation.empty()) lines << QString::fromStdString(fact.equation);
    if (!fact.place.empty()) lines << QString::fromStdString(fact.place);
    return literalToolTip(lines.join('\n'));
}

QString valueOf(const ExplanationFact& fact) {
    const QString value = QString::fromStdString(fact.value);
    return fact.unit.empty() ? value : value + ' ' + QString::fromStdString(fact.unit);
}

}  // namespace

TubeCorePanel::TubeCorePanel(QWidget* parent)
    : QWidget(parent),
      m_shown(named(new QCheckBox(tr("Tube cores in the pictures")), "tubeCores.shown",
                    tr("Tube cores in the pictures"),
                    tr("Draws the tube cores in the planes and in the 3D view, with the surfaces they found. A click "
                       "on one explains it (T)"))),
      m_sentence(createText("tubeCores.sentence", tr("What became of the tube core"))),
      m_note(createText("tubeCores.note", tr("What the picture shows"))),
      m_map(new TubeCoreMap),
      m_list(new TubeCoreList),
      m_parameters(new ReadingParameters("tubeCores")),
      m_below(new QWidget) {
    setObjectName("tubeCores");
    setAccessibleName(tr("Tube cores"));
    connect(m_shown, &QCheckBox::clicked, this, &TubeCorePanel::shownToggled);
    connect(m_map, &TubeCoreMap::chosen, this, &TubeCorePanel::chosen);
    connect(m_list, &TubeCoreList::chosen, this, &TubeCorePanel::chosen);
    connect(m_parameters, &ReadingParameters::configChanged, this, &TubeCorePanel::configChanged);
    createExplanation();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_shown);
    column->addWidget(m_map);
    column->addWidget(new Disclosure("tubeCores.listShown", tr("List"), tr("All tube cores as a table"), m_list));
    column->addWidget(m_sentence);
    column->addWidget(m_note);
    column->addWidget(new Disclosure("tubeCores.parameters", tr("Parameters of the reading"),
                                     tr("What a tube core finds depends on these. They are those of the panel Method"),
                                     m_parameters));
    column->addWidget(m_below);
    column->addStretch(1);
    setRun(nullptr);
    setNote({});
}

void TubeCorePanel::createExplanation() {
    m_facts = named(new FittedTable({tr("Symbol"), tr("Value")}, fontMetrics().height() + 5), "tubeCores.facts",
                    tr("What the tube core found"));
    m_facts->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_facts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_facts->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_facts->verticalHeader()->hide();
    m_facts->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_facts->setShowGrid(false);
    m_facts->setAlternatingRowColors(true);

    const auto plot = [](const char* name, int height) {
        auto* canvas = new PlotCanvas(nullptr, height);
        canvas->setObjectName(name);
        return canvas;
    };
    m_profile = plot("tubeCores.plot.profile", plotHeight);
    m_interface = plot("tubeCores.plot.interface", plotHeight);
    m_intensityRank = plot("tubeCores.plot.intensityRank", plotHeight);
    m_slopeRank = plot("tubeCores.plot.slopeRank", plotHeight);
    m_factors = plot("tubeCores.plot.factors", plotHeight);
    m_curves = plot("tubeCores.plot.curves", curvesHeight);
    m_change = plot("tubeCores.plot.change", changeHeight);

    m_growth = named(new QSlider(Qt::Horizontal), "tubeCores.growth", tr("Grows core by core"),
                     tr("The curve made of the heaviest tube cores alone, each with its weight of the full run"));
    wheelNeedsFocus(m_growth);
    connect(m_growth, &QSlider::valueChanged, this, &TubeCorePanel::grow);
    m_growthWords = createText("tubeCores.growthWords", tr("Of how many tube cores the curve is made"));
    m_compare = named(new QPushButton(tr("Compare without it")), "tubeCores.compare", tr("Compare without it"),
                      tr("Opens the comparison: the curve of all tube cores beside that of all but this one"));
    connect(m_compare, &QPushButton::clicked, this, &TubeCorePanel::compareRequested);
    auto* page = named(new QPushButton(tr("Save page…")), "tubeCores.savePage", tr("Save page…"),
                       tr("Saves the facts, the plots and three pictures as one page that opens without a network"));
    connect(page, &QPushButton::clicked, this, &TubeCorePanel::pageRequested);

    auto* column = new QVBoxLayout(m_below);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_facts);
    for (PlotCanvas* canvas : {m_profile, m_interface, m_intensityRank, m_slopeRank, m_factors, m_curves})
        column->addWidget(canvas);
    column->addWidget(labelFor(m_growth, tr("Grows core by core")));
    column->addWidget(m_growth);
    column->addWidget(m_growthWords);
    column->addWidget(m_change);
    column->addWidget(createPictures());
    column->addWidget(m_compare);
    column->addWidget(page);
}

QWidget* TubeCorePanel::createPictures() {
    auto* row = new QWidget;
    auto* grid = new QGridLayout(row);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(2);
    const std::array<const char*, pictures> names{"all", "without", "third"};
    const QStringList words{tr("all"), tr("without"), tr("alone")};
    for (int which = 0; which < pictures; ++which) {
        const auto place = static_cast<std::size_t>(which);
        const QString name = QStringLiteral("tubeCores.picture.") + names[place];
        auto* picture = m_pictures[place] = named(new QLabel, name, tr("Picture: %1").arg(words[which]));
        picture->setFixedSize(pictureWidth, pictureHeight);
        picture->setAlignment(Qt::AlignCenter);
        picture->setProperty("smallPicture", true);
        m_pictureWords[place] = secondaryLabel(words[which]);
        m_pictureWords[place]->setAlignment(Qt::AlignHCenter);
        grid->addWidget(picture, 0, which);
        grid->addWidget(m_pictureWords[place], 1, which);
    }
    grid->setColumnStretch(pictures, 1);
    return row;
}

void TubeCorePanel::setShown(bool shown) { m_shown->setChecked(shown); }

void TubeCorePanel::setRun(std::shared_ptr<const AdaptiveOtf> run) {
    m_run = std::move(run);
    m_map->setRun(m_run);
    m_list->setRun(m_run);
    m_map->setVisible(m_run != nullptr);
    if (!m_run) setExplanation(nullptr);
    setChosen(m_chosen);
}

void TubeCorePanel::setChosen(std::optional<int> number) {
    m_chosen = number;
    m_map->setChosen(number);
    m_list->setChosen(number);
    if (!number) setExplanation(nullptr);
    showWords();
    enableCompare();
}

void TubeCorePanel::setExplanation(std::shared_ptr<const ShownExplanation> explanation) {
    const bool another =
        !explanation || !m_explanation || explanation->explanation->number != m_explanation->explanation->number;
    m_explanation = std::move(explanation);
    if (another) m_grown.reset();
    m_below->setVisible(m_explanation != nullptr);
    showWords();
    if (!m_explanation) return;
    showFacts();
    m_profile->setPlot(m_explanation->profile);
    m_interface->setPlot(m_explanation->interfaceFunction);
    m_intensityRank->setPlot(m_explanation->ranks[0]);
    m_slopeRank->setPlot(m_explanation->ranks[1]);
    m_factors->setPlot(m_explanation->factors);
    m_change->setPlot(m_explanation->change);
    {
        const QSignalBlocker blocker(m_growth);
        m_growth->setRange(0, m_explanation->weighing);
        m_growth->setValue(m_grown.value_or(m_explanation->weighing));
        if (m_grown) m_grown = m_growth->value();
    }
    showGrown();
}

void TubeCorePanel::showWords() {
    QString words;
    if (!m_run)
        words = tr("There is no curve yet: no volume is open, or the curve is still being computed.");
    else if (m_explanation && m_chosen)
        words = QString::fromStdString(m_explanation->sentence);
    else if (!m_chosen && m_run->tubesWithWeight == 0)
        words = tr("No tube core has a weight. %1").arg(QString::fromStdString(m_run->message));
    else if (!m_chosen)
        words = tr("Click a tube core here, in the list or in a picture, and the panel explains it.");
    m_sentence->setText(words);
    m_sentence->setVisible(!words.isEmpty());
}

void TubeCorePanel::enableCompare() {
    const bool there = m_run && m_chosen && static_cast<std::size_t>(*m_chosen) < m_run->tubes.size();
    const TubeState state = there ? stateOf(*m_run, *m_chosen) : TubeState::outside;
    enableOrSayWhy(*m_compare, state != TubeState::outside && state != TubeState::neverPlaced,
                   state == TubeState::neverPlaced
                       ? tr("The tube core is never placed: the curve is made without it already.")
                       : tr("The tube core meets no data: the curve is the same without it."));
}

void TubeCorePanel::setNote(const QString& sentence) {
    m_note->setText(sentence);
    m_note->setVisible(!sentence.isEmpty());
}

void TubeCorePanel::setConfig(const AdaptiveOtfConfig& config) { m_parameters->setConfig(config); }

void TubeCorePanel::showFacts() {
    const auto& facts = m_explanation->facts;
    m_facts->setRowCount(static_cast<int>(facts.size()));
    for (int row = 0; row < m_facts->rowCount(); ++row) {
        const ExplanationFact& fact = facts[static_cast<std::size_t>(row)];
        const std::array<QString, 2> texts{QString::fromStdString(fact.symbol), valueOf(fact)};
        for (int column = 0; column < 2; ++column) {
            if (m_facts->item(row, column) == nullptr) m_facts->setItem(row, column, new QTableWidgetItem);
            m_facts->item(row, column)->setText(texts[static_cast<std::size_t>(column)]);
            m_facts->item(row, column)->setToolTip(toolTipOf(fact));
        }
    }
    m_facts->fit();
}

SampledCurve TubeCorePanel::thirdCurve() const {
    if (!m_explanation) return {};
    return m_grown ? grownCurve(*m_explanation->run, static_cast<std::size_t>(*m_grown))
                   : m_explanation->explanation->alone.curve;
}

void TubeCorePanel::grow(int count) {
    if (!m_explanation) return;
    m_grown = count;
    showGrown();
    emit grownChanged();
}

void TubeCorePanel::showGrown() {
    const int all = m_explanation->weighing, count = m_grown.value_or(all);
    const auto grown = static_cast<std::size_t>(count);
    // Also before the slider is moved: a line that came with it would make the legend higher, and push the slider away.
    Plot plot = m_explanation->curves;
    plot.series.push_back(grownSeries(grownCurve(*m_explanation->run, grown), grown, static_cast<std::size_t>(all)));
    m_curves->setPlot(plot);
    m_growthWords->setText(tr("%1 of %2 tube cores, heaviest first").arg(count).arg(all));
    m_growth->setEnabled(all > 0);
    const QString words = m_grown ? tr("%1 heaviest").arg(count) : tr("alone");
    m_pictureWords[third]->setText(words);
    m_pictures[third]->setAccessibleName(tr("Picture: %1").arg(words));
}

void TubeCorePanel::setPicture(Picture which, const QImage& image) {
    QLabel* label = m_pictures.at(static_cast<std::size_t>(which));
    image.isNull() ? label->clear() : label->setPixmap(QPixmap::fromImage(image));
}

}  // namespace echolucent
