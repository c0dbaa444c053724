#include "widgets/otf_editor/otf_editor.h"

#include <QActionGroup>
#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_text.h"
#include "widgets/key_table.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/curve_legend.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/editor_tool_row.h"
#include "widgets/otf_editor/node_reduction.h"
#include "widgets/otf_editor/node_table.h"
#include "widgets/otf_editor/parameter_panel.h"

namespace echolucent {

namespace {

constexpr int shownNodeRows = 4;  // of the node table, without scrolling

/// The lowest of 256 intensities at which the curve reaches an opacity; no value if it never does.
std::optional<double> intensityReaching(const OpacityCurve& curve, double opacity) {
    const std::vector<double> opacities = sampledOpacities(curve, 256);
    const auto reached = std::ranges::find_if(opacities, [opacity](double value) { return value >= opacity; });
    if (reached == opacities.end()) return std::nullopt;
    return static_cast<double>(reached - opacities.begin()) / 255.0;
}

}  // namespace

OtfEditor::OtfEditor(DocumentModel& document, QWidget* parent) : QWidget(parent), m_model(document) {
    setObjectName("otfEditor");
    setAccessibleName(tr("Opacity transfer function"));
    makeActions();
    makePresets();
    m_canvas = new CurveCanvas(m_model);
    m_readout = secondaryLabel();
    m_readout->setObjectName("otfEditor.readout");
    m_readout->setAccessibleName(tr("Values under the pointer"));
    m_readout->setWordWrap(true);
    m_readout->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    column->addLayout(makeToolRow());
    column->addWidget(m_canvas, 1);
    column->addWidget(m_readout);
    column->addWidget(new CurveLegend(m_model));
    column->addWidget(m_pages = makePages());
    column->addLayout(makeFileRow());
    connectModel();
    fitLetters();
    paintIcons();
    showState();
    showAdaptiveFacts();
}

OtfEditor::~OtfEditor() {
    // Destroy the widgets first: a field commits its half typed number as the focus goes, and the table uses the model.
    hide();
    steps().disconnect(this);
    qDeleteAll(findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
}

void OtfEditor::makeActions() {
    const auto make = [this](QAction*& action, const QString& text, const QString& name) {
        action = new QAction(text, this);
        action->setObjectName("otfEditor.action." + name);
        action->setShortcut(keyOf(action->objectName()));
        addAction(action);
    };
    make(m_undo, tr("Undo"), "undo");
    make(m_redo, tr("Redo"), "redo");
    make(m_reset, tr("Reset curve"), "reset");
    make(m_copyAdaptive, tr("Copy adaptive into nodes"), "copyAdaptive");
    make(m_openCurve, tr("Open curve…"), "openCurve");
    make(m_saveCurve, tr("Save curve…"), "saveCurve");
    make(m_addNode, tr("Add node"), "addNode");
    make(m_deleteNode, tr("Delete node"), "deleteNode");
    m_openCurve->setToolTip(tr("Open a manual curve from a file"));
    m_saveCurve->setToolTip(tr("Save the curve that is rendered to a file"));
    m_addNode->setToolTip(tr("Add a node on the curve, after the selected one"));
    m_deleteNode->setToolTip(tr("Delete the selected node (Delete)"));
    connect(m_undo, &QAction::triggered, &steps(), &DocumentSteps::undo);
    connect(m_redo, &QAction::triggered, &steps(), &DocumentSteps::redo);
    connect(m_reset, &QAction::triggered, &m_model, &OtfEditorModel::resetActiveCurve);
    connect(m_copyAdaptive, &QAction::triggered, &m_model, &OtfEditorModel::copyIntoNodes);
    connect(m_openCurve, &QAction::triggered, this, &OtfEditor::openCurveRequested);
    connect(m_saveCurve, &QAction::triggered, this, &OtfEditor::saveCurveRequested);
    connect(m_addNode, &QAction::triggered, &m_model, &OtfEditorModel::addNodeInGap);
    connect(m_deleteNode, &QAction::triggered, this, [this] { m_model.removeNode(m_model.selectedNode()); });
    auto* group = new QActionGroup(this);
    for (const CurveKind kind : allCurveKinds) {
        QAction*& action = m_activate[indexOf(kind)];
        make(action, tr("Render %1").arg(curveName(kind)), "active." + curveKey(kind));
        action->setCheckable(true);
        group->addAction(action);
        connect(action, &QAction::triggered, &m_model, [this, kind] { m_model.setActive(kind); });
    }
}

void OtfEditor::makePresets() {
    m_presets = new QMenu(tr("Begin with"), this);
    m_presets->setObjectName("otfEditor.presets.menu");
    for (const CurvePreset& preset : curvePresets()) {
        QAction* action = m_presets->addAction(preset.name);
        action->setObjectName("otfEditor.presets." + preset.key);
        connect(action, &QAction::triggered, &m_model,
                [this, preset] { m_model.replaceManual(preset.curve, tr("begin with %1").arg(preset.name)); });
    }
}

QLayout* OtfEditor::makeToolRow() {
    auto* row = new EditorToolRow({m_undo, m_redo, m_reset, m_presets});
    connect(row, &EditorToolRow::histogramLogarithmic, this, [this](bool logarithmic) {
        m_canvas->setHistogramScale(logarithmic ? HistogramScale::logarithmic : HistogramScale::linear);
    });
    m_earlyLight = &row->earlyLight();
    connect(m_earlyLight, &QCheckBox::toggled, this, &OtfEditor::earlyLightSwitched);
    return row;
}

QStackedWidget* OtfEditor::makePages() {
    auto* pages = new QStackedWidget;
    pages->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // the plot must not jump when the page changes
    pages->addWidget(makeAdaptivePage());                              // in the order of allCurveKinds
    pages->addWidget(makeManualPage());
    pages->addWidget(new LinearParameters(m_model));
    pages->addWidget(new PowerParameters(m_model, CurveKind::parabolic));
    pages->addWidget(new PowerParameters(m_model, CurveKind::quartic));
    pages->addWidget(makeDesignPage());  // after the pages of the curves
    return pages;
}

QWidget* OtfEditor::makeAdaptivePage() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    m_adaptiveNote = secondaryLabel();
    m_adaptiveNote->setObjectName("otfEditor.adaptive.note");
    m_adaptiveNote->setAccessibleName(tr("Note on the adaptive curve"));
    m_adaptiveNote->setWordWrap(true);
    m_adaptiveNote->setTextFormat(Qt::RichText);
    column->addWidget(m_adaptiveNote);
    column->addStretch(1);
    return page;
}

QWidget* OtfEditor::makeDesignPage() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    m_designNote = secondaryLabel();
    m_designNote->setObjectName("otfEditor.design.note");
    m_designNote->setAccessibleName(tr("Note on the designer's OTF"));
    m_designNote->setWordWrap(true);
    m_designNote->setTextFormat(Qt::PlainText);
    column->addWidget(m_designNote);
    column->addStretch(1);
    return page;
}

QWidget* OtfEditor::makeManualPage() {
    auto* page = new QWidget;
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_nodeTable = new NodeTable(m_model);
    row->addWidget(m_nodeTable, 1);
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(4);
    for (QToolButton* button : {buttonFor(m_addNode, "otfEditor.addNode", Qt::ToolButtonTextOnly),
                                buttonFor(m_deleteNode, "otfEditor.deleteNode", Qt::ToolButtonTextOnly)}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    row->addLayout(buttons);
    return page;
}

QLayout* OtfEditor::makeFileRow() {
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    QToolButton* copy = buttonFor(m_copyAdaptive, "otfEditor.copyAdaptive", Qt::ToolButtonTextOnly);
    copy->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    rows->addWidget(copy);
    auto* files = new QHBoxLayout;
    files->setSpacing(4);
    for (QToolButton* button : {buttonFor(m_openCurve, "otfEditor.openCurve", Qt::ToolButtonTextOnly),
                                buttonFor(m_saveCurve, "otfEditor.saveCurve", Qt::ToolButtonTextOnly)}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        files->addWidget(button);
    }
    rows->addLayout(files);
    return rows;
}

void OtfEditor::connectModel() {
    connect(&m_model, &OtfEditorModel::changed, this, &OtfEditor::showState);
    connect(&m_model, &OtfEditorModel::activeCurveChanged, this, &OtfEditor::activeCurveChanged);
    const auto showSteps = [this] {
        const QString undo = steps().canUndo() ? tr("Undo %1").arg(steps().undoText()) : tr("Undo");
        const QString redo = steps().canRedo() ? tr("Redo %1").arg(steps().redoText()) : tr("Redo");
        // Names that people gave to presets and snapshots stand in them.
        m_undo->setText(literalMenuText(undo));
        m_redo->setText(literalMenuText(redo));
        m_undo->setToolTip(literalToolTip(tr("%1 (Ctrl+Z)").arg(undo)));
        m_redo->setToolTip(literalToolTip(tr("%1 (Ctrl+Shift+Z)").arg(redo)));
        enableOrSayWhy(*m_undo, steps().canUndo(), tr("Nothing was changed."));
        enableOrSayWhy(*m_redo, steps().canRedo(), tr("Nothing was undone."));
    };
    connect(&steps(), &DocumentSteps::changed, this, showSteps);
    showSteps();
    connect(m_canvas, &CurveCanvas::hovered, this, &OtfEditor::showHovered);
    connect(m_nodeTable, &NodeTable::refused, m_readout, &QLabel::setText);
}

void OtfEditor::setAdaptiveCurve(const SampledCurve& curve) {
    m_model.setAdaptiveCurve(curve);
    m_playing ? m_adaptiveFacts.tell() : m_adaptiveFacts.tellNow();
}

void OtfEditor::setDesign(const QString& designer, const std::optional<OpacityCurve>& upper) {
    m_model.setDesign(designer.toStdString(), upper);
}

QString OtfEditor::renderedName() const {
    return state().designed ? QString::fromStdString(state().designer) : curveName(state().active);
}

void OtfEditor::setHistogram(const IntensityHistogram& histogram) { m_canvas->setHistogram(histogram); }

bool OtfEditor::showsEarlyLight() const { return m_earlyLight->isChecked(); }
void OtfEditor::setShowsEarlyLight(bool shows) { m_earlyLight->setChecked(shows); }
void OtfEditor::setEarlyLight(const std::optional<EarlyLight>& light) { m_canvas->setEarlyLight(light); }

void OtfEditor::setValueWindow(const ValueWindow& window) {
    m_values = window;
    m_canvas->setValueWindow(window);
    m_nodeTable->setValueWindow(window);
    showState();
    showAdaptiveFacts();
}

void OtfEditor::setCursorIntensity(std::optional<double> intensity) {
    m_cursorIntensity = intensity;
    m_canvas->setCursorIntensity(intensity);
    showReadout();
}

void OtfEditor::openManualCurve(const ManualCurve& curve) {
    m_model.replaceManual(curve, tr("open curve"));
    m_model.setManualSaved();
}

void OtfEditor::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) paintIcons();
    // The letters of what stands in it follow.
    if (event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &OtfEditor::fitLetters, Qt::QueuedConnection);
    QWidget::changeEvent(event);
}

void OtfEditor::fitLetters() {
    m_readout->setFixedHeight(2 * m_readout->fontMetrics().height() + 2);  // the plot must not move
    m_nodeTable->fitRows(shownNodeRows);
}

void OtfEditor::paintIcons() {
    const QColor color = palette().color(QPalette::Active, QPalette::WindowText);
    QColor faded = color;
    faded.setAlphaF(0.35F);
    m_undo->setIcon(bentArrowIcon(true, color, faded));
    m_redo->setIcon(bentArrowIcon(false, color, faded));
}

void OtfEditor::showState() {
    const OtfEditorState& shown = state();
    const bool computed = !shown.adaptive.opacities.empty();
    for (const CurveKind kind : allCurveKinds)
        m_activate[indexOf(kind)]->setChecked(kind == shown.active && !shown.designed);
    m_pages->setCurrentIndex(static_cast<int>(shown.designed ? allCurveKinds.size() : indexOf(shown.active)));
    const QString copied = shown.designed ? QString::fromStdString(shown.designer) : tr("adaptive");
    m_copyAdaptive->setText(tr("Copy %1 into nodes").arg(copied));
    const bool canCopy = shown.designed ? shown.design.has_value() : computed;
    const QString copying =
        shown.designed
            ? tr("Copy the largest opacity of each intensity into few nodes, within %1").arg(copiedCurveMaxError)
            : tr("Copy the adaptive curve into few nodes, within %1 of its opacity").arg(copiedCurveMaxError);
    m_copyAdaptive->setToolTip(copying);
    enableOrSayWhy(*m_copyAdaptive, canCopy, tr("It is not computed yet."));
    m_designNote->setText(shown.design ? tr("%1 made the OTF from the volume. The panel Designers says how and has its "
                                            "parameters. To edit its curve, copy it into nodes.")
                                             .arg(copied)
                                       : tr("No OTF of %1 yet: it is computed from the volume.").arg(copied));
    const bool ofVolume = shown.designed || shown.active == CurveKind::adaptive;
    const bool nothingToReset = ofVolume && shown.adjustment == CurveAdjustment{};
    m_reset->setToolTip(tr("Reset the %1 curve (C)").arg(renderedName()));
    enableOrSayWhy(*m_reset, !nothingToReset, tr("It comes from the volume, and nothing was changed."));
    enableOrSayWhy(*m_deleteNode, m_model.selectedNode() >= 0 && m_model.canRemoveNode(),
                   tr("No node is selected that a curve can spare."));
    if (m_hoveredNode >= static_cast<int>(shown.manual.nodes.size())) m_hoveredNode = -1;
    if (m_hoveredNode >= 0) m_hovered = shown.manual.nodes[static_cast<std::size_t>(m_hoveredNode)];
    showReadout();
}

void OtfEditor::setPlaying(bool playing) {
    m_playing = playing;
    m_adaptiveFacts.tellNow();
}

void OtfEditor::showAdaptiveFacts() {
    const bool computed = !state().adaptive.opacities.empty();
    m_adaptiveNote->setText(computed ? adaptiveFacts() : tr("No adaptive curve yet: it is computed from the volume."));
}

QString OtfEditor::adaptiveFacts() const {
    const QString cell = QStringLiteral("<td align='right' style='padding-left:12px; white-space:nowrap'>%1</td>");
    QString opacities;
    QString intensities;
    QString values;
    for (const double opacity : {0.01, 0.1, 0.5, 0.9}) {
        const std::optional<double> intensity = intensityReaching(state().adaptive, opacity);
        opacities += cell.arg(opacity);
        intensities += cell.arg(intensity ? intensityText(*intensity) : tr("never"));
        values += cell.arg(intensity ? valueText(m_values.valueAt(*intensity), m_values) : QString());
    }
    const QString rowOfValues =
        m_values.isNormalised() ? QString() : QString("<tr><td>%1</td>%2</tr>").arg(tr("value"), values);
    return tr("Computed from the volume. To edit it, copy it into nodes.") +
           QString(
               "<table cellspacing='0' cellpadding='1' style='margin-top:6px'><tr><td>%1</td>%2</tr>"
               "<tr><td>%3</td>%4</tr>%5</table>")
               .arg(tr("Opacity reaches"), opacities, tr("at intensity"), intensities, rowOfValues);
}

QString OtfEditor::intensityText(double intensity) const { return QString::number(intensity, 'f', 3); }

void OtfEditor::showHovered(std::optional<CurveNode> value, int node) {
    m_hovered = value;
    m_hoveredNode = node;
    showReadout();
}

void OtfEditor::showReadout() {
    const auto values = [this](const CurveNode& value) {
        return tr("intensity %1%2   opacity %3")
            .arg(intensityText(value.intensity), valueBeside(value.intensity, m_values))
            .arg(value.opacity, 0, 'f', 3);
    };
    const auto onCurve = [this](double intensity) {
        return tr("   %1 %2").arg(renderedName()).arg(opacityAt(activeCurve(), intensity), 0, 'f', 3);
    };
    if (m_hovered && m_hoveredNode >= 0) {
        m_readout->setText(tr("Node %1   %2").arg(m_hoveredNode + 1).arg(values(*m_hovered)));
    } else if (m_hovered) {
        m_readout->setText(values(*m_hovered) + onCurve(m_hovered->intensity));
    } else if (m_cursorIntensity) {
        m_readout->setText(tr("In the picture   intensity %1%2")
                               .arg(intensityText(*m_cursorIntensity), valueBeside(*m_cursorIntensity, m_values)) +
                           onCurve(*m_cursorIntensity));
    } else {
        m_readout->setText(tr("Double click adds a node, Delete removes it, the wheel zooms"));
    }
}

}  // namespace echolucent
