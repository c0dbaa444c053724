#include "widgets/otf_editor/curve_canvas.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/controls/value_text.h"
#include "widgets/larger_letters.h"
#include "widgets/otf_editor/early_light_bars.h"

namespace echolucent {

namespace {

constexpr double nudgeStep = 1.0 / 256.0;
constexpr double coarseNudgeFactor = 10.0;
constexpr double zoomPerNotch = 0.85;
constexpr double wheelNotch = 120.0;  // one notch: 15 degrees in Qt's unit, an eighth of a degree

}  // namespace

CurveCanvas::CurveCanvas(OtfEditorModel& model, QWidget* parent) : QWidget(parent), m_model(model) {
    setObjectName("otfEditor.canvas");
    setAccessibleName(tr("Opacity curves"));
    describe();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&m_model, &OtfEditorModel::changed, this, qOverload<>(&QWidget::update));
    connect(&m_model, &OtfEditorModel::changed, this, [this] { tellNodeChanged(*this, m_model.selectedNode()); });
    connect(&m_model, &OtfEditorModel::selectedNodeChanged, this, [this](int node) { tellNodeChosen(*this, node); });
    layOutPlot();
}

void CurveCanvas::setHistogram(const IntensityHistogram& histogram) {
    m_histogram = histogram;
    m_histogramHeights = histogramHeights(m_histogram, m_histogramScale);
    update();
}

void CurveCanvas::setHistogramScale(HistogramScale scale) {
    m_histogramScale = scale;
    m_histogramHeights = histogramHeights(m_histogram, m_histogramScale);
    update();
}

void CurveCanvas::setEarlyLight(const std::optional<EarlyLight>& light) {
    if (std::exchange(m_earlyLight, light) == light) return;
    describe();
    update();
}

void CurveCanvas::describe() {
    const QString words = m_earlyLight ? QStringLiteral(" ") + wordsOf(*m_earlyLight) + QLatin1Char('.') : QString();
    setAccessibleDescription(tr("Opacity over intensity. Tab goes from node to node, arrow keys move the selected one, "
                                "Delete removes it.") +
                             words);
}

void CurveCanvas::setValueWindow(const ValueWindow& window) {
    m_values = window;
    layOutPlot();
}

void CurveCanvas::setCursorIntensity(std::optional<double> intensity) {
    if (m_cursorIntensity == intensity) return;
    m_cursorIntensity = intensity;
    update();
}

void CurveCanvas::setIntensityRange(const AxisRange& range) { setAxisRange(m_axes.intensity, range); }
void CurveCanvas::setOpacityRange(const AxisRange& range) { setAxisRange(m_axes.opacity, range); }

void CurveCanvas::setAxisRange(AxisRange& range, const AxisRange& wanted) {
    if (range == wanted) return;
    range = wanted;
    update();
}

void CurveCanvas::resetZoom() {
    setIntensityRange({});
    setOpacityRange({});
}

QSize CurveCanvas::sizeHint() const { return inLettersOf(*this, QSize(400, 250)); }

QSize CurveCanvas::minimumSizeHint() const { return inLettersOf(*this, QSize(260, 150)); }

double CurveCanvas::halfOfValues() const {
    double longest = 0.0;
    if (!m_values.isNormalised())
        for (const double intensity : {0.0, 0.3, 0.7, 1.0})
            longest = std::max<double>(
                longest, QFontMetrics(font()).horizontalAdvance(valueText(m_values.valueAt(intensity), m_values)));
    return longest / 2;
}

double CurveCanvas::valueRowGap() const {
    constexpr double least = 18.0, apart = 6.0;
    return std::max(least, halfOfValues() + apart);
}

void CurveCanvas::layOutPlot() {
    const QFontMetrics metrics(font());
    const double numbersAndTitle = metrics.horizontalAdvance("0.000") + metrics.height() + 6;
    const double rowName = valueRowGap() + metrics.horizontalAdvance(tr("value"));
    const double left = std::max(numbersAndTitle, m_values.isNormalised() ? 0.0 : rowName);
    const double rows = m_values.isNormalised() ? 1.0 : 2.0;
    const double bottom = rows * metrics.height() + 7;
    const double right = std::max(metrics.horizontalAdvance("0000") / 2.0, halfOfValues()) + 2;
    const double top = metrics.height() / 2.0 + 2;
    m_axes.rect = QRectF(left, top, std::max(10.0, width() - left - right), std::max(10.0, height() - top - bottom));
    update();
}

CurveCanvas::Region CurveCanvas::regionAt(QPointF position) const {
    const QRectF& rect = m_axes.rect;
    const bool besidePlot = position.x() < rect.left() - 2;
    const bool belowPlot = position.y() > rect.bottom() + 2;
    if (besidePlot) return belowPlot ? Region::corner : Region::opacityAxis;
    return belowPlot ? Region::intensityAxis : Region::plot;
}

int CurveCanvas::nodeAt(QPointF position) const {
    if (!m_model.state().visible[indexOf(CurveKind::manual)]) return -1;
    const auto& nodes = m_model.state().manual.nodes;
    int nearest = -1;
    double nearestDistance = inLettersOf(*this, hitDistance);
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
        const QPointF away = m_axes.positionOf(nodes[static_cast<std::size_t>(i)]) - position;
        const double distance = std::max(std::abs(away.x()), std::abs(away.y()));
        // If two nodes lie on each other, take the selected one.
        if (distance < nearestDistance || (distance == nearestDistance && i == m_model.selectedNode())) {
            nearest = i;
            nearestDistance = distance;
        }
    }
    return nearest;
}

std::vector<SpokenNode> CurveCanvas::spokenNodes() const {
    if (!m_model.state().visible[indexOf(CurveKind::manual)]) return {};
    const auto& nodes = m_model.state().manual.nodes;
    std::vector<SpokenNode> spoken;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
        const CurveNode& node = nodes[static_cast<std::size_t>(i)];
        spoken.push_back({spokenNameOf(i, nodes.size(), tr("intensity %1").arg(node.intensity, 0, 'f', 3)),
                          node.opacity, placeOfNode(m_axes.positionOf(node), inLettersOf(*this, hitDistance)),
                          i == m_model.selectedNode()});
    }
    return spoken;
}

void CurveCanvas::chooseSpokenNode(int node) {
    setFocus(Qt::OtherFocusReason);
    m_model.selectNode(node);
}

void CurveCanvas::setSpokenOpacity(int node, double opacity) {
    const double intensity = m_model.state().manual.nodes[static_cast<std::size_t>(node)].intensity;
    m_model.moveNode(node, {intensity, opacity});
    if (node != m_model.selectedNode()) tellNodeChanged(*this, node);
}

bool CurveCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && handlesKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();  // elsewhere the arrows turn the view, here they move the node
        return true;
    }
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        const int nodes = static_cast<int>(m_model.state().manual.nodes.size());
        if (event->type() == QEvent::FocusIn && reason == Qt::TabFocusReason) m_model.selectNode(0);
        if (event->type() == QEvent::FocusIn && reason == Qt::BacktabFocusReason) m_model.selectNode(nodes - 1);
        update();
    }
    return QWidget::event(event);
}

bool CurveCanvas::focusNextPrevChild(bool next) {
    // Tab leaves past the last node, so that the keyboard is never caught here.
    return selectNeighbour(next ? 1 : -1) || QWidget::focusNextPrevChild(next);
}

void CurveCanvas::resizeEvent(QResizeEvent*) { layOutPlot(); }

void CurveCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        layOutPlot();
        updateGeometry();
    }
    QWidget::changeEvent(event);
}

void CurveCanvas::mousePressEvent(QMouseEvent* event) {
    if (m_grab) return;  // a second button does not change the drag
    const QPointF position = event->position();
    Grab grab{event->button(), -1, position, {}, m_axes.intensity, m_axes.opacity};
    if (event->button() == Qt::LeftButton) {
        const int node = nodeAt(position);
        m_model.selectNode(node);
        if (node < 0) return;
        grab.node = node;
        grab.value = m_model.state().manual.nodes[static_cast<std::size_t>(node)];
        m_grab = grab;
        m_model.beginDrag();
    } else if (event->button() == Qt::MiddleButton) {
        m_grab = grab;
        setCursor(Qt::ClosedHandCursor);
    }
}

void CurveCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_grab && m_grab->node >= 0) {
        dragTo(event->position(), event->modifiers());
    } else if (m_grab) {
        panTo(event->position());
    }
    hoverAt(event->position());
}

void CurveCanvas::dragTo(QPointF position, Qt::KeyboardModifiers modifiers) {
    if (!m_model.dragging()) {  // an undo elsewhere has ended the drag
        m_grab.reset();
        return;
    }
    QPointF moved = position - m_grab->position;
    if (modifiers & Qt::ShiftModifier) (std::abs(moved.x()) >= std::abs(moved.y()) ? moved.ry() : moved.rx()) = 0.0;
    m_model.dragNode(m_grab->node,
                     {m_grab->value.intensity + m_axes.intensity.length() * moved.x() / m_axes.rect.width(),
                      m_grab->value.opacity - m_axes.opacity.length() * moved.y() / m_axes.rect.height()});
}

void CurveCanvas::panTo(QPointF position) {
    const QPointF moved = position - m_grab->position;
    setIntensityRange(m_grab->intensity.moved(-moved.x() / m_axes.rect.width() * m_grab->intensity.length()));
    setOpacityRange(m_grab->opacity.moved(moved.y() / m_axes.rect.height() * m_grab->opacity.length()));
}

void CurveCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_grab || event->button() != m_grab->button) return;
    if (m_grab->node >= 0) m_model.endDrag();
    m_grab.reset();
    hoverAt(event->position());
}

void CurveCanvas::endGrabWithoutChange() {
    if (!m_grab) return;
    if (m_grab->node >= 0) m_model.cancelDrag();
    setIntensityRange(m_grab->intensity);
    setOpacityRange(m_grab->opacity);
    m_grab.reset();
}

void CurveCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const QPointF position = event->position();
    switch (regionAt(position)) {
        case Region::plot:
            if (nodeAt(position) < 0) m_model.addNode(m_axes.valueAt(position));
            break;
        case Region::intensityAxis: setIntensityRange({}); break;
        case Region::opacityAxis: setOpacityRange({}); break;
        case Region::corner: resetZoom(); break;
    }
    hoverAt(position);
}

void CurveCanvas::wheelEvent(QWheelEvent* event) {
    if (m_grab) return;
    const double notches = event->angleDelta().y() / wheelNotch;
    const double factor = std::pow(zoomPerNotch, notches);
    const CurveNode anchor = m_axes.valueAt(event->position());
    const Region region = regionAt(event->position());
    if (region == Region::opacityAxis || (event->modifiers() & Qt::ControlModifier)) {
        setOpacityRange(m_axes.opacity.zoomed(anchor.opacity, factor, minOpacityLength));
    } else {
        setIntensityRange(m_axes.intensity.zoomed(anchor.intensity, factor, minIntensityLength));
    }
    hoverAt(event->position());
    event->accept();
}

bool CurveCanvas::handlesKey(const QKeyEvent& event) const {
    if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
    switch (event.key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Delete: return m_model.selectedNode() >= 0;
        case Qt::Key_PageUp:
        case Qt::Key_PageDown: return true;
        case Qt::Key_Escape: return m_grab.has_value();
        default: return false;
    }
}

void CurveCanvas::keyPressEvent(QKeyEvent* event) {
    if (!handlesKey(*event)) return QWidget::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_Delete:
            endGrabWithoutChange();
            m_model.removeNode(m_model.selectedNode());
            break;
        case Qt::Key_Escape: endGrabWithoutChange(); break;
        case Qt::Key_PageUp: selectNeighbour(-1); break;
        case Qt::Key_PageDown: selectNeighbour(1); break;
        default: nudgeSelected(*event);
    }
    if (m_pointer) hoverAt(*m_pointer);
}

bool CurveCanvas::nudgeSelected(const QKeyEvent& event) {
    endGrabWithoutChange();
    if (!event.isAutoRepeat()) m_nudgeGesture = m_model.newGesture();
    const double step = event.modifiers() & Qt::ShiftModifier ? coarseNudgeFactor * nudgeStep : nudgeStep;
    CurveNode node = m_model.state().manual.nodes[static_cast<std::size_t>(m_model.selectedNode())];
    switch (event.key()) {
        case Qt::Key_Left: node.intensity -= step; break;
        case Qt::Key_Right: node.intensity += step; break;
        case Qt::Key_Up: node.opacity += step; break;
        case Qt::Key_Down: node.opacity -= step; break;
        default: return false;
    }
    m_model.moveNode(m_model.selectedNode(), node, m_nudgeGesture);
    return true;
}

bool CurveCanvas::selectNeighbour(int step) {
    const int nodes = static_cast<int>(m_model.state().manual.nodes.size());
    if (!m_model.state().visible[indexOf(CurveKind::manual)]) return false;
    const int none = step > 0 ? -1 : nodes;
    const int next = (m_model.selectedNode() < 0 ? none : m_model.selectedNode()) + step;
    if (next < 0 || next >= nodes) return false;
    endGrabWithoutChange();
    m_model.selectNode(next);
    return true;
}

void CurveCanvas::hoverAt(QPointF position) {
    const Region region = regionAt(position);
    m_pointer = position;
    m_hoveredNode = m_grab && m_grab->node >= 0 ? m_grab->node : nodeAt(position);
    if (!m_grab || m_grab->node >= 0) {
        constexpr std::array<Qt::CursorShape, 4> shapes{Qt::CrossCursor, Qt::SizeHorCursor, Qt::SizeVerCursor,
                                                        Qt::ArrowCursor};
        setCursor(m_hoveredNode >= 0 ? Qt::SizeAllCursor : shapes[static_cast<std::size_t>(region)]);
    }
    if (m_hoveredNode >= 0) {
        emit hovered(m_model.state().manual.nodes[static_cast<std::size_t>(m_hoveredNode)], m_hoveredNode);
    } else if (m_axes.rect.contains(position)) {
        emit hovered(m_axes.valueAt(position), -1);
    } else {
        emit hovered(std::nullopt, -1);
    }
    update();
}

void CurveCanvas::leaveEvent(QEvent*) {
    m_pointer.reset();
    m_hoveredNode = -1;
    emit hovered(std::nullopt, -1);
    update();
}

void CurveCanvas::hideEvent(QHideEvent*) { endGrabWithoutChange(); }

}  // namespace echolucent
