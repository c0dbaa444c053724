#include "widgets/theory/theory_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "processing/theory/theory_plots.h"
#include "widgets/controls/narrow_combo.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_slider.h"
#include "widgets/fitted_table.h"
#include "widgets/plots/plot_canvas.h"

namespace echolucent {

namespace {

constexpr double white = 255.0;  // the paper gives intensities up to it
constexpr double mostUnits = 200.0;
constexpr int plotHeight = 130;

QString textOf(const std::optional<double>& share) { return QString::fromStdString(shareText(share)); }

ValueSlider* slider(const char* name, const QString& accessibleName, double step, int decimals) {
    return new ValueSlider(QString::fromLatin1(name), accessibleName, step, decimals);
}

PlotCanvas* canvas(const char* name) {
    auto* made = new PlotCanvas(nullptr, plotHeight);
    made->setObjectName(name);
    return made;
}

}  // namespace

TheoryPanel::TheoryPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("theory");
    setAccessibleName(tr("Theory"));
    auto* grid = new QGridLayout;
    addSliders(*grid);
    addChoices(*grid);
    m_words = named(new QLabel, "theory.words", tr("Which curve shows the tissue best"));
    m_words->setWordWrap(true);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_origin = secondaryLabel();
    named(m_origin, "theory.origin", tr("Where the curves come from"));
    m_origin->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->addLayout(grid);
    column->addLayout(createButtons());
    column->addWidget(m_words);
    column->addWidget(m_contrastPlot = canvas("theory.contrastPlot"));
    column->addWidget(m_table = createTable());
    column->addWidget(m_pixelPlot = canvas("theory.pixelPlot"));
    column->addWidget(m_origin);
    column->addWidget(m_curvePlot = canvas("theory.curvePlot"));
    column->addStretch(1);
    showControls();
    followStudy();
}

ValueSlider* TheoryPanel::addSlider(QGridLayout& grid, const QString& label, ValueSlider* slider,
                                    const Change& change) {
    const int row = grid.rowCount();
    grid.addWidget(labelFor(slider, label), row, 0);
    grid.addWidget(slider, row, 1);
    connect(slider, &ValueSlider::valueChanged, this, [this, change](double value) {
        change(m_setting, value);
        follow();
    });
    return slider;
}

void TheoryPanel::addSliders(QGridLayout& grid) {
    m_tissue = slider("theory.tissue", tr("c1: intensity of tissue, 0 to 255"), 1.0, 1);
    m_fluid = slider("theory.fluid", tr("c2: intensity of fluid, 0 to 255"), 1.0, 1);
    m_fluidUnits = slider("theory.fluidUnits", tr("Thickness of the fluid, units"), 1.0, 0);
    m_tissueUnits = slider("theory.tissueUnits", tr("Thickness of the tissue, units"), 1.0, 0);
    m_scale = slider("theory.scale", tr("a: a factor on all opacities"), 0.05, 2);
    m_tissue->setRange(0.0, white);
    m_fluid->setRange(0.0, white);
    m_fluidUnits->setRange(0.0, mostUnits);
    m_tissueUnits->setRange(0.0, mostUnits);
    m_scale->setRange(0.0, TheorySetting::largestScale);
    m_tissue->setToolTip(tr("c1 of section 4: the intensity of the tissue behind, 0 to 255"));
    m_fluid->setToolTip(tr("c2 of section 4: the intensity that rays meet first, 0 to 255"));
    m_fluidUnits->setToolTip(tr("How thick the fluid is before the tissue, in samples of one unit: k* of section 4"));
    m_tissueUnits->setToolTip(tr("How thick the tissue is, up to the end of the ray, in samples of one unit"));
    m_scale->setToolTip(tr("a of section 4: a factor on all opacities"));
    addSlider(grid, tr("Tissue c1"), m_tissue,
              [](TheorySetting& to, double value) { to.model.tissue = value / white; });
    addSlider(grid, tr("Fluid c2"), m_fluid, [](TheorySetting& to, double value) { to.model.fluid = value / white; });
    addSlider(grid, tr("Fluid, units"), m_fluidUnits,
              [](TheorySetting& to, double value) { to.model.fluidUnits = static_cast<std::int64_t>(value); });
    addSlider(grid, tr("Tissue, units"), m_tissueUnits,
              [](TheorySetting& to, double value) { to.model.tissueUnits = static_cast<std::int64_t>(value); });
    addSlider(grid, tr("Opacity a"), m_scale, [](TheorySetting& to, double value) { to.scale = value; });
}

void TheoryPanel::addChoices(QGridLayout& grid) {
    const auto add = [&](const char* name, const QString& label, const QString& tip,
                         const std::vector<std::pair<QString, int>>& entries, const std::function<void(int)>& take) {
        auto* combo = named(new NarrowCombo, QString::fromLatin1(name), label, tip);
        for (const auto& [text, value] : entries) combo->addItem(text, value);
        wheelNeedsFocus(combo);
        const int row = grid.rowCount();
        grid.addWidget(labelFor(combo, label), row, 0);
        grid.addWidget(combo, row, 1);
        connect(combo, &QComboBox::currentIndexChanged, this, [this, combo, take] {
            take(combo->currentData().toInt());
            follow();
        });
        return combo;
    };
    m_scaling = add("theory.scaling", tr("Compared at"),
                    tr("The same a: as the paper writes the curves, higher powers are less opaque in tissue too. The "
                       "same opacity at c1: every curve is multiplied until tissue is as opaque as under a x"),
                    {{tr("The same a"), static_cast<int>(OpacityScaling::sameScale)},
                     {tr("The same opacity at c1"), static_cast<int>(OpacityScaling::sameAtTissue)}},
                    [this](int value) { m_setting.scaling = static_cast<OpacityScaling>(value); });
    m_contrast =
        add("theory.contrast", tr("Contrast"),
            tr("Difference: pixel into tissue less pixel of fluid alone. Michelson: difference over sum. Weber: "
               "difference over the fluid's pixel. The relative ones rise as fluid turns black, however dark "
               "tissue is"),
            {{tr("Difference"), static_cast<int>(ContrastKind::difference)},
             {tr("Michelson"), static_cast<int>(ContrastKind::michelson)},
             {tr("Weber"), static_cast<int>(ContrastKind::weber)}},
            [this](int value) { m_setting.contrast = static_cast<ContrastKind>(value); });
    m_axisChoice = add("theory.axis", tr("Over"), tr("What runs along the plots"),
                       {{tr("Thickness of the fluid"), static_cast<int>(CourseAxis::depth)},
                        {tr("c2 / c1"), static_cast<int>(CourseAxis::ratio)}},
                       [this](int value) { m_axis = static_cast<CourseAxis>(value); });
}

QLayout* TheoryPanel::createButtons() {
    m_fromStudy =
        named(new QPushButton(tr("From this study")), "theory.fromStudy", tr("From this study"),
              tr("Takes c1 and c2 from the surfaces that the adaptive method found in the shown study (I_H and "
                 "I_L), and the study's adaptive curve, eq. 1, x² and x⁴ as they are edited"));
    auto* reset = named(new QPushButton(tr("Reset")), "theory.reset", tr("Reset the theory"),
                        tr("The values and curves of the start: tissue and fluid of the simulated scans"));
    connect(m_fromStudy, &QPushButton::clicked, this, &TheoryPanel::takeFromStudy);
    connect(reset, &QPushButton::clicked, this, [this] { setSetting({}); });
    auto* row = new QHBoxLayout;
    row->addWidget(m_fromStudy);
    row->addWidget(reset);
    row->addStretch(1);
    return row;
}

FittedTable* TheoryPanel::createTable() {
    const QStringList headings{tr("C of\nfluid"), tr("C into\ntissue"), tr("Contrast")};
    auto* table =
        named(new FittedTable(headings), "theory.table", tr("Pixels and contrast of each curve"),
              tr("C(r) by eqs. 2 and 3, share of white: of a ray through fluid alone, and of one into tissue"));
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    return table;
}

void TheoryPanel::setSetting(const TheorySetting& setting) {
    m_setting = setting;
    showControls();
    follow();
}

void TheoryPanel::setStudy(std::function<std::optional<StudyIntensities>()> study) {
    m_study = std::move(study);
    followStudy();
}

void TheoryPanel::followStudy() {
    enableOrSayWhy(*m_fromStudy, m_study && m_study().has_value(),
                   tr("The adaptive method has found no surface in the shown study."));
}

void TheoryPanel::takeFromStudy() {
    const auto study = m_study ? m_study() : std::nullopt;
    if (!study) return followStudy();
    TheorySetting next = m_setting;
    next.model.tissue = study->tissue;
    next.model.fluid = study->fluid;
    next.given = study->given;
    setSetting(next);
}

void TheoryPanel::showControls() {
    m_tissue->setValue(white * m_setting.model.tissue);
    m_fluid->setValue(white * m_setting.model.fluid);
    m_fluidUnits->setValue(static_cast<double>(m_setting.model.fluidUnits));
    m_tissueUnits->setValue(static_cast<double>(m_setting.model.tissueUnits));
    m_scale->setValue(m_setting.scale);
    selectData(m_scaling, static_cast<int>(m_setting.scaling));
    selectData(m_contrast, static_cast<int>(m_setting.contrast));
    m_origin->setText(
        m_setting.given == GivenCurves{}
            ? tr("The paper's curves; adaptive: of one tube core that found this surface.")
            : tr("x², x⁴, eq. 1 and the adaptive curve of the study, as they were when they were taken."));
}

void TheoryPanel::follow() {
    m_stale = true;
    if (isVisible()) tell();
}

void TheoryPanel::tell() {
    if (!std::exchange(m_stale, false)) return;
    m_words->setText(QString::fromStdString(winnerSentence(m_setting)));
    showTable();
    const ContrastCourse course = courseOf(m_setting, m_axis);
    m_contrastPlot->setPlot(contrastPlot(m_setting, course, m_axis));
    m_pixelPlot->setPlot(pixelPlot(m_setting, course, m_axis));
    m_curvePlot->setPlot(opacityPlot(m_setting));
}

void TheoryPanel::showTable() {
    const std::vector<CurveContrast> contrasts = contrastsOf(m_setting);
    m_table->setRowCount(static_cast<int>(contrasts.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const CurveContrast& one = contrasts[static_cast<std::size_t>(row)];
        m_table->setVerticalHeaderItem(row, new QTableWidgetItem(QString::fromStdString(one.name)));
        const std::optional<double> cells[] = {one.pixels.fluid, one.pixels.tissue, one.contrast};
        for (int column = 0; column < m_table->columnCount(); ++column) {
            auto* item = new QTableWidgetItem(textOf(cells[column]));
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
    }
    m_table->fit();
}

void TheoryPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    tell();
}

}  // namespace echolucent
