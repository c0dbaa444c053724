#include "widgets/otf_editor/otf_editor_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/node_reduction.h"

namespace echolucent {

namespace {

constexpr int announceIntervalMs = 16;  // one frame of a 60 Hz screen

double inUnitInterval(double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; }

std::ptrdiff_t offset(int index) { return static_cast<std::ptrdiff_t>(index); }

/// The middle of the gap for a new node. The gaps before the first and after the last node count too.
double middleOfGap(const std::vector<CurveNode>& nodes, int selected) {
    const auto next = static_cast<std::size_t>(selected + 1);
    if (selected >= 0 && next < nodes.size() && nodes[next].intensity > nodes[next - 1].intensity)
        return (nodes[next - 1].intensity + nodes[next].intensity) / 2;
    double widest = 0.0;
    double middle = 0.5;
    double left = 0.0;
    for (std::size_t i = 0; i <= nodes.size(); ++i) {
        const double right = i < nodes.size() ? nodes[i].intensity : 1.0;
        if (right - left > widest) {
            widest = right - left;
            middle = (left + right) / 2;
        }
        left = right;
    }
    return middle;
}

}  // namespace

OtfEditorModel::OtfEditorModel(DocumentModel& document, QObject* parent) : QObject(parent), m_document(document) {
    m_announceTimer.setSingleShot(true);
    m_announceTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_announceTimer, &QTimer::timeout, this, &OtfEditorModel::announceNow);
    connect(&m_document, &DocumentModel::curvesChanged, this, &OtfEditorModel::takeFromDocument);
    connect(&m_document, &DocumentModel::panesChanged, this, &OtfEditorModel::takeFromDocument);
    takeFromDocument();
    m_savedManual = m_state.manual;
    updateManualModified();
}

void OtfEditorModel::setActive(CurveKind kind) {
    cancelDrag();
    OtfEditorState next = m_state;
    next.active = kind;
    next.designed = false;
    next.visible[indexOf(kind)] = true;
    // A person may go through the curves to compare them. One undo goes back to the first curve.
    constexpr Gesture choosing = -1;
    edit(next, tr("choose curve"), choosing);
    announceNow();
}

void OtfEditorModel::setVisible(CurveKind kind, bool visible) {
    OtfEditorState next = m_state;
    next.visible[indexOf(kind)] = visible;
    apply(next, Announce::soon);
}

void OtfEditorModel::setAdaptiveCurve(const SampledCurve& curve) {
    OtfEditorState next = m_state;
    next.adaptive = curve;
    apply(next, Announce::now);
}

void OtfEditorModel::setDesign(const std::string& designer, const std::optional<OpacityCurve>& upper) {
    OtfEditorState next = m_state;
    next.designer = designer;
    next.design = upper;
    apply(next, Announce::now);
}

void OtfEditorModel::setDesignVisible(bool visible) {
    OtfEditorState next = m_state;
    next.designVisible = visible;
    apply(next, Announce::soon);
}

OtfEditorState OtfEditorModel::withManualActive() const {
    OtfEditorState next = m_state;
    next.designed = false;
    next.active = CurveKind::manual;
    next.visible[indexOf(CurveKind::manual)] = true;
    return next;
}

int OtfEditorModel::addNode(const CurveNode& node) {
    cancelDrag();
    const CurveNode clamped{inUnitInterval(node.intensity), inUnitInterval(node.opacity)};
    OtfEditorState next = withManualActive();
    auto& nodes = next.manual.nodes;
    const auto after =
        std::upper_bound(nodes.begin(), nodes.end(), clamped.intensity,
                         [](double intensity, const CurveNode& other) { return intensity < other.intensity; });
    const int index = static_cast<int>(after - nodes.begin());
    nodes.insert(after, clamped);
    edit(next, tr("add node"));
    selectNode(index);
    return index;
}

int OtfEditorModel::addNodeInGap() {
    const double intensity = middleOfGap(m_state.manual.nodes, m_selectedNode);
    return addNode({intensity, opacityAt(m_state.manual, intensity)});
}

void OtfEditorModel::moveNode(int index, const CurveNode& node, Gesture gesture) {
    cancelDrag();
    OtfEditorState next = withManualActive();
    next.manual.nodes.at(static_cast<std::size_t>(index)) = clampedNode(index, node);
    if (next.manual != m_state.manual) edit(next, tr("move node"), gesture);
}

void OtfEditorModel::removeNode(int index) {
    cancelDrag();
    if (!canRemoveNode() || index < 0 || index >= static_cast<int>(m_state.manual.nodes.size())) return;
    OtfEditorState next = withManualActive();
    next.manual.nodes.erase(next.manual.nodes.begin() + offset(index));
    edit(next, tr("delete node"));
    selectNode(std::min(index, static_cast<int>(m_state.manual.nodes.size()) - 1));
}

void OtfEditorModel::replaceManual(const ManualCurve& curve, const QString& what) {
    cancelDrag();
    OtfEditorState next = withManualActive();
    next.manual = curve;
    edit(next, what);
}

bool OtfEditorModel::copyIntoNodes() {
    if (m_state.designed) {
        if (!m_state.design) return false;
        constexpr int samples = 1024;  // a two-dimensional OTF has at most this many nodes
        const SampledCurve upper{sampledOpacities(*m_state.design, samples)};
        replaceManual(reducedToNodes(upper, copiedCurveMaxError),
                      tr("copy %1 into nodes").arg(QString::fromStdString(m_state.designer)));
        return true;
    }
    if (m_state.adaptive.opacities.empty()) return false;
    replaceManual(reducedToNodes(m_state.adaptive, copiedCurveMaxError), tr("copy adaptive into nodes"));
    return true;
}

void OtfEditorModel::setLinear(const LinearCurve& curve, Gesture gesture) {
    cancelDrag();
    OtfEditorState next = m_state;
    next.linear.lower = inUnitInterval(curve.lower);
    next.linear.upper = std::max(next.linear.lower, inUnitInterval(curve.upper));
    next.linear.slope = std::isfinite(curve.slope) ? std::max(curve.slope, 0.0) : m_state.linear.slope;
    edit(next, tr("change piecewise linear curve"), gesture);
}

void OtfEditorModel::setScale(CurveKind kind, double scale, Gesture gesture) {
    cancelDrag();
    if (!std::isfinite(scale)) return;
    OtfEditorState next = m_state;
    PowerCurve& power = kind == CurveKind::parabolic ? next.parabolic : next.quartic;
    power.scale = std::max(scale, 0.0);
    edit(next, tr("change scale"), gesture);
}

void OtfEditorModel::resetActiveCurve() {
    cancelDrag();
    const CurveSet standard{};
    OtfEditorState next = m_state;
    // A designer's OTF comes from the volume, as the adaptive curve does: there is nothing to reset.
    switch (m_state.designed ? CurveKind::adaptive : m_state.active) {
        case CurveKind::adaptive: break;
        case CurveKind::manual: next.manual = standard.manual; break;
        case CurveKind::linear: next.linear = standard.linear; break;
        case CurveKind::parabolic: next.parabolic = standard.parabolic; break;
        case CurveKind::quartic: next.quartic = standard.quartic; break;
    }
    next.adjustment = standard.adjustment;
    edit(next, m_state.designed ? tr("reset threshold and transparency")
                                : tr("reset %1 curve").arg(curveName(m_state.active)));
}

void OtfEditorModel::beginDrag() {
    if (!m_beforeDrag) m_beforeDrag = m_state;
}

void OtfEditorModel::dragNode(int index, const CurveNode& node) {
    if (!m_beforeDrag) return;
    OtfEditorState next = withManualActive();
    next.manual.nodes.at(static_cast<std::size_t>(index)) = clampedNode(index, node);
    // Until the node has really moved, the drag changes nothing, not even the active curve.
    if (next.manual != m_state.manual) preview(next);
}

void OtfEditorModel::endDrag() {
    if (!m_beforeDrag) return;
    if (m_beforeDrag->manual == m_state.manual) return cancelDrag();  // dragged back to where it began
    m_beforeDrag.reset();
    m_document.commitPreview();
    announceNow();
}

void OtfEditorModel::cancelDrag() {
    if (!m_beforeDrag) return;
    const OtfEditorState before = *std::exchange(m_beforeDrag, std::nullopt);
    m_document.cancelPreview();
    OtfEditorState shown = m_state;
    shown.visible = before.visible;
    apply(shown, Announce::now);
}

CurveNode OtfEditorModel::clampedNode(int index, const CurveNode& node) const {
    const auto& nodes = m_state.manual.nodes;
    const auto i = static_cast<std::size_t>(index);
    const double lower = i > 0 ? nodes[i - 1].intensity : 0.0;
    const double upper = i + 1 < nodes.size() ? nodes[i + 1].intensity : 1.0;
    return {std::isnan(node.intensity) ? nodes.at(i).intensity : std::clamp(node.intensity, lower, upper),
            std::isnan(node.opacity) ? nodes.at(i).opacity : inUnitInterval(node.opacity)};
}

void OtfEditorModel::selectNode(int index) {
    const int selected = index < static_cast<int>(m_state.manual.nodes.size()) ? std::max(index, -1) : -1;
    if (selected == m_selectedNode) return;
    m_selectedNode = selected;
    emit selectedNodeChanged(selected);
    emit changed();
}

void OtfEditorModel::setManualSaved() {
    m_savedManual = m_state.manual;
    updateManualModified();
}

void OtfEditorModel::edit(const OtfEditorState& next, const QString& what, Gesture gesture) {
    if (next.visible != m_state.visible) {  // the visibility of curves is no part of the step
        OtfEditorState shown = m_state;
        shown.visible = next.visible;
        apply(shown, Announce::soon);
    }
    m_announce = gesture == noGesture ? Announce::now : Announce::soon;
    m_document.edit(documentOf(next), what, gesture);
    m_announce = Announce::now;
}

void OtfEditorModel::preview(const OtfEditorState& next) {
    OtfEditorState shown = m_state;
    shown.visible = next.visible;
    apply(shown, Announce::soon);
    m_announce = Announce::soon;
    m_draggedNode = true;
    m_document.preview(documentOf(next), tr("move node"));
    m_draggedNode = false;
    m_announce = Announce::now;
}

Document OtfEditorModel::documentOf(const OtfEditorState& next) const {
    Document document = withCurves(m_document.document(), firstPane, next);
    if (!next.designed) return withCurve(std::move(document), firstPane, next.active);
    document.panes.at(firstPane).curve = next.active;
    return document;
}

void OtfEditorModel::takeFromDocument() {
    const CurveSet curves = curvesOf(m_document.document(), firstPane);
    const Pane& pane = m_document.document().panes.at(firstPane);
    const bool designed = pane.designer.has_value();
    if (curves == static_cast<const CurveSet&>(m_state) && pane.curve == m_state.active && designed == m_state.designed)
        return;
    if (m_beforeDrag && !m_draggedNode && !m_document.previewing()) m_beforeDrag.reset();  // an undo has ended the drag
    OtfEditorState next = m_state;
    static_cast<CurveSet&>(next) = curves;
    if (next.active != pane.curve) next.visible[indexOf(pane.curve)] = true;
    next.active = pane.curve;
    next.designed = designed;
    if (!next.designed) next.design.reset();
    apply(next, m_announce);
}

void OtfEditorModel::apply(const OtfEditorState& next, Announce announce) {
    const OtfEditorState before = std::exchange(m_state, next);
    if (before.manual != m_state.manual) {
        if (m_selectedNode >= static_cast<int>(m_state.manual.nodes.size())) selectNode(-1);
        updateManualModified();
        emit manualEdited(m_state.manual);
    } else {
        updateManualModified();
    }
    if (before != m_state) emit changed();
    if (announce == Announce::now) {
        announceNow();
    } else if (!m_announceTimer.isActive() && activeCurve() != m_announced) {
        const qint64 since = m_sinceAnnounced.isValid() ? m_sinceAnnounced.elapsed() : announceIntervalMs;
        m_announceTimer.start(static_cast<int>(std::clamp<qint64>(announceIntervalMs - since, 0, announceIntervalMs)));
    }
}

void OtfEditorModel::announceNow() {
    m_announceTimer.stop();
    OpacityCurve curve = activeCurve();
    if (curve == m_announced) return;
    m_announced = std::move(curve);
    m_sinceAnnounced.restart();
    emit activeCurveChanged(m_announced);
}

void OtfEditorModel::updateManualModified() {
    const auto isPreset = [this](const CurvePreset& preset) { return preset.curve == m_state.manual; };
    m_manualModified = m_state.manual != m_savedManual && std::ranges::none_of(curvePresets(), isPreset);
}

}  // namespace echolucent
