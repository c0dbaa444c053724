#include "widgets/panels/designer_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "processing/designers/choice/designer.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/panels/design_plot.h"
#include "widgets/panels/designer_parameters.h"
#include "widgets/panels/emphasis_canvas.h"

namespace echolucent {

namespace {

constexpr int curveEntry = -1;  // entry of the choice: a curve, no designer

QLabel* wordsLabel(const QString& name, const QString& accessibleName) {
    auto* label = named(new QLabel, name, accessibleName);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    return label;
}

QString factText(double value) { return QLocale::c().toString(value, 'g', 4); }

QString withUnit(const QString& text, const std::string& unit) {
    return unit.empty() ? text : text + QLatin1Char(' ') + QString::fromStdString(unit);
}

}  // namespace

DesignerPanel::DesignerPanel(DocumentModel& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("designer");
    setAccessibleName(tr("OTF designers"));
    makeChoice();
    makeProgress();
    makeWords();
    makePlots();
    makeEmphasis();
    m_parameters = new DesignerParameters;
    connect(m_parameters, &DesignerParameters::changed, this,
            [this](const DesignerConfig& config, const QString& label) {
                // If a person chooses another designer while typing a number, the hidden field still reports that
                // number. Ignore its report.
                if (!m_config || m_config->index() != config.index()) return;
                take(config, tr("%1: %2").arg(nameOfDesigner(), label.toLower()));
            });

    auto* layout = new QVBoxLayout(this);
    auto* choice = new QHBoxLayout;
    choice->addWidget(labelFor(m_choice, tr("OTF")));
    choice->addWidget(m_choice, 1);
    choice->addWidget(m_reset);
    layout->addLayout(choice);
    layout->addWidget(m_parameters);
    layout->addWidget(m_emphasis);
    layout->addWidget(m_computing);
    layout->addWidget(m_compute);
    layout->addWidget(m_message);
    layout->addWidget(m_explanation);
    layout->addWidget(m_plot);
    layout->addWidget(m_canvas);
    layout->addWidget(m_plotHint);
    layout->addWidget(m_facts);
    layout->addStretch(1);
    setDesign(nullptr, 0);
    setComputing(false, false);
    m_document.bind(&DocumentModel::panesChanged, this,
                    [this](const Document& shown) { showConfig(designerConfigOf(shown, firstPane)); });
}

void DesignerPanel::makeChoice() {
    m_choice = named(new QComboBox, "designer.choice", tr("What makes the OTF"),
                     tr("Renders one of the five curves, or the OTF that a designer makes from the volume"));
    m_choice->addItem(tr("Curve"), curveEntry);
    for (const Designer designer : allDesigners)
        m_choice->addItem(textOf(labelOf(designer)), static_cast<int>(designer));
    wheelNeedsFocus(m_choice);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &DesignerPanel::choose);
    m_reset = resetButton("designer.reset", tr("Set the designer's parameters back"));
    connect(m_reset, &QToolButton::clicked, this, &DesignerPanel::resetParameters);
}

void DesignerPanel::choose() {
    const Document& document = m_document.document();
    const int entry = m_choice->currentData().toInt();
    if (entry == curveEntry)
        return m_document.edit(withCurve(document, firstPane, document.panes.at(firstPane).curve), tr("choose curve"));
    const auto designer = static_cast<Designer>(entry);
    take(defaultConfigOf(designer), tr("choose designer %1").arg(textOf(labelOf(designer))));
}

void DesignerPanel::take(const DesignerConfig& config, const QString& what, bool dragging) {
    m_document.take(withDesigner(m_document.document(), firstPane, config), what, dragging);
}

void DesignerPanel::makeProgress() {
    m_computing = new QWidget;
    m_progress = named(new QProgressBar, "designer.progress", tr("Progress of the designer"));
    m_progress->setTextVisible(false);
    m_progress->setMaximumHeight(12);
    m_cancel = named(new QToolButton, "designer.cancel", tr("Cancel"), tr("Ends what the designer computes"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setFocusPolicy(Qt::StrongFocus);
    connect(m_cancel, &QToolButton::clicked, this, &DesignerPanel::cancelRequested);
    auto* row = new QHBoxLayout(m_computing);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_progress, 1);
    row->addWidget(m_cancel);
    // The column must not jump when a run begins or ends.
    QSizePolicy keepsRoom = m_computing->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_computing->setSizePolicy(keepsRoom);
    m_compute = named(new QPushButton(tr("Compute")), "designer.compute", tr("Compute"),
                      tr("Computes the OTF that was cancelled or could not be made"));
    connect(m_compute, &QPushButton::clicked, this, &DesignerPanel::computeRequested);
}

void DesignerPanel::makeWords() {
    m_message = wordsLabel("designer.message", tr("What could not be done"));
    m_message->setTextFormat(Qt::PlainText);
    m_explanation = wordsLabel("designer.explanation", tr("What was found, and why the OTF is as it is"));
    m_explanation->setTextFormat(Qt::PlainText);
    m_facts = wordsLabel("designer.facts", tr("Numbers that the designer found or used"));
    m_facts->setTextFormat(Qt::RichText);
}

void DesignerPanel::makePlots() {
    m_plot = named(new QComboBox, "designer.plot", tr("What is plotted over the intensity"),
                   tr("Functions over the intensity that the designer looked at"));
    m_plot->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    wheelNeedsFocus(m_plot);
    m_canvas = named(new DesignPlotCanvas, "designer.plot.canvas", tr("Plot over the intensity"));
    m_plotHint = secondaryLabel(tr("A click on a maximum puts the ramp there."));
    m_plotHint->setWordWrap(true);
    connect(m_plot, &QComboBox::currentIndexChanged, this, &DesignerPanel::showPlot);
    connect(m_canvas, &DesignPlotCanvas::picked, this, &DesignerPanel::pick);
}

void DesignerPanel::makeEmphasis() {
    m_emphasis = named(new EmphasisCanvas, "designer.emphasis.canvas", tr("Boundary emphasis function"),
                       tr("Opacity by where a voxel lies in a boundary. Drag a node, double click adds one, Delete "
                          "removes it"));
    connect(
        m_emphasis, &EmphasisCanvas::edited, this,
        [this](const std::vector<EmphasisNode>& nodes, const QString& what) { changeEmphasis(nodes, what, false); });
    connect(m_emphasis, &EmphasisCanvas::previewed, this, [this](const std::vector<EmphasisNode>& nodes) {
        changeEmphasis(nodes, tr("move node of emphasis"), true);
    });
    connect(m_emphasis, &EmphasisCanvas::dragEnded, &m_document, &DocumentModel::commitPreview);
    connect(m_emphasis, &EmphasisCanvas::dragCancelled, &m_document, &DocumentModel::cancelPreview);
}

QString DesignerPanel::nameOfDesigner() const { return m_config ? textOf(labelOf(designerOf(*m_config))) : QString(); }

void DesignerPanel::showConfig(const DesignerConfig* config) {
    const auto before = std::exchange(m_config, config != nullptr ? std::optional(*config) : std::nullopt);
    const bool another = before.has_value() != m_config.has_value() || (before && before->index() != m_config->index());
    selectData(m_choice, m_config ? static_cast<int>(designerOf(*m_config)) : curveEntry);
    if (m_config) m_parameters->setConfig(*m_config);
    if (another) setDesign(nullptr, 0);
    showParts();
    showPlot();
}

void DesignerPanel::showParts() {
    const auto* kindlmann = m_config ? std::get_if<KindlmannConfig>(&*m_config) : nullptr;
    bool parameters = false;
    if (m_config) forEachParameter(std::as_const(*m_config), [&](const auto&, const auto&) { parameters = true; });
    m_parameters->setVisible(parameters);
    enableOrSayWhy(*m_reset, m_config && *m_config != defaultConfigOf(designerOf(*m_config)),
                   tr("The parameters have their values at start."));
    m_emphasis->setVisible(kindlmann != nullptr && kindlmann->emphasis == BoundaryEmphasis::drawn);
    if (kindlmann != nullptr) m_emphasis->setNodes(kindlmann->drawn);
}

void DesignerPanel::setDesign(const Design* design, double milliseconds) {
    const QString message = design != nullptr ? QString::fromStdString(design->message) : QString();
    m_message->setText(message.isEmpty() ? message : QStringLiteral("⚠ ") + message);
    m_message->setVisible(!message.isEmpty());
    QStringList sentences;
    if (!m_config)
        sentences << tr("The 3D view is rendered with a curve. A designer makes the OTF from the volume.");
    else if (design == nullptr)
        sentences << tr("The OTF is not computed yet.");
    if (m_config && std::holds_alternative<AdaptiveConfig>(*m_config))
        sentences << tr("The panel Method has the parameters of the adaptive method.");
    if (design != nullptr)
        for (const std::string& sentence : design->explanation) sentences << QString::fromStdString(sentence);
    m_explanation->setText(sentences.join(QStringLiteral("\n\n")));
    m_facts->setVisible(design != nullptr);
    if (design != nullptr) showFacts(*design, milliseconds);

    m_plots = design != nullptr ? design->plots : std::vector<DesignPlot>();
    const QString before = m_plot->currentText();
    {
        const QSignalBlocker blocker(m_plot);
        m_plot->clear();
        for (const DesignPlot& plot : m_plots)
            m_plot->addItem(withUnit(QString::fromStdString(plot.label),
                                     plot.unit.empty() ? std::string() : "(" + plot.unit + ")"));
        m_plot->setCurrentIndex(std::max(m_plot->findText(before), m_plots.empty() ? -1 : 0));
    }
    showPlot();
}

void DesignerPanel::showFacts(const Design& design, double milliseconds) {
    QString rows;
    const auto add = [&rows](const QString& label, const QString& value) {
        rows += QStringLiteral("<tr><td style='padding-right:12px'>%1</td><td align='right'>%2</td></tr>")
                    .arg(label.toHtmlEscaped(), value.toHtmlEscaped());
    };
    for (const DesignFact& fact : design.facts)
        add(QString::fromStdString(fact.label), withUnit(factText(fact.value), fact.unit));
    add(tr("Time"), tr("%1 ms").arg(QLocale::c().toString(milliseconds, 'f', milliseconds < 10 ? 1 : 0)));
    m_facts->setText(QStringLiteral("<table cellspacing='0' cellpadding='1'>%1</table>").arg(rows));
}

void DesignerPanel::showPlot() {
    const int index = m_plot->currentIndex();
    const bool any = index >= 0 && index < static_cast<int>(m_plots.size());
    const bool pickable = any && m_config && std::holds_alternative<ContourSpectrumConfig>(*m_config) &&
                          withThreshold(*m_config, 0.5).has_value();
    m_plot->setVisible(any);
    m_canvas->setVisible(any);
    m_plotHint->setVisible(pickable);
    if (!any) return;
    m_canvas->setPlot(m_plots[static_cast<std::size_t>(index)]);
    m_canvas->setPickable(pickable);
    m_canvas->setAccessibleDescription(m_plot->currentText());
    m_canvas->setMarked(pickable ? thresholdOf(*m_config) : std::nullopt);
}

void DesignerPanel::setComputing(bool computing, bool refused) {
    if (computing && m_computing->isHidden()) m_progress->setRange(0, 0);  // busy, until the share is known
    m_computing->setVisible(computing);
    m_compute->setVisible(!computing && refused);
}

void DesignerPanel::setProgress(double share) { showShare(m_progress, share); }

void DesignerPanel::setValueWindow(const ValueWindow& window) { m_parameters->setValueWindow(window); }

void DesignerPanel::resetParameters() {
    if (!m_config) return;
    take(defaultConfigOf(designerOf(*m_config)), tr("%1: defaults").arg(nameOfDesigner()));
}

void DesignerPanel::pick(double intensity) {
    if (!m_config) return;
    const auto next = withThreshold(*m_config, intensity);
    if (next && *next != *m_config) take(*next, tr("%1: threshold").arg(nameOfDesigner()));
}

void DesignerPanel::changeEmphasis(const std::vector<EmphasisNode>& nodes, const QString& what, bool preview) {
    if (!m_config || !std::holds_alternative<KindlmannConfig>(*m_config)) return;
    DesignerConfig next = *m_config;
    std::get<KindlmannConfig>(next).drawn = nodes;
    take(next, what, preview);
}

}  // namespace echolucent
