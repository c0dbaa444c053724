#include "widgets/panels/emphasis_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/larger_letters.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/plot_colours.h"

namespace echolucent {

namespace {
constexpr std::size_t fewestNodes = 2;  // as problemOf(KindlmannConfig) requires
constexpr double keyStep = 0.05;
}  // namespace

EmphasisCanvas::EmphasisCanvas(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setToolTip(
        tr("Opacity by where a voxel lies in a boundary. Drag a node, double click adds one, Delete removes it"));
}

void EmphasisCanvas::setNodes(const std::vector<EmphasisNode>& nodes) {
    if (nodes != m_nodes) m_dragging = m_moved = false;  // an undo has ended the drag
    m_nodes = nodes;
    if (m_selected >= static_cast<int>(m_nodes.size())) m_selected = -1;
    update();
}

QRectF EmphasisCanvas::area() const {
    const int line = fontMetrics().height();
    return QRectF(rect()).adjusted(fontMetrics().horizontalAdvance("0.5") + 10.0, 8, -12, -2.0 * line - 6);
}

QPointF EmphasisCanvas::positionOf(const EmphasisNode& node) const {
    const QRectF plot = area();
    return {plot.left() + plot.width() * (node.position + shownPositions) / (2 * shownPositions),
            plot.bottom() - plot.height() * node.opacity};
}

EmphasisNode EmphasisCanvas::valueAt(QPointF position) const {
    const QRectF plot = area();
    const double along = 2 * shownPositions * (position.x() - plot.left()) / plot.width() - shownPositions;
    const double up = (plot.bottom() - position.y()) / plot.height();
    return {std::clamp(along, -shownPositions, shownPositions), std::clamp(up, 0.0, 1.0)};
}

int EmphasisCanvas::nodeAt(QPointF position) const {
    const double hit = inLettersOf(*this, hitDistance);
    for (int i = static_cast<int>(m_nodes.size()) - 1; i >= 0; --i) {
        const QPointF distance = positionOf(m_nodes[static_cast<std::size_t>(i)]) - position;
        if (std::abs(distance.x()) <= hit && std::abs(distance.y()) <= hit) return i;
    }
    return -1;
}

EmphasisNode EmphasisCanvas::clamped(int index, const EmphasisNode& node) const {
    const auto i = static_cast<std::size_t>(index);
    const double least = i > 0 ? m_nodes[i - 1].position : std::min(-shownPositions, m_nodes[i].position);
    const double largest =
        i + 1 < m_nodes.size() ? m_nodes[i + 1].position : std::max(shownPositions, m_nodes[i].position);
    return {std::clamp(node.position, least, largest), std::clamp(node.opacity, 0.0, 1.0)};
}

void EmphasisCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotColours colours = plotColours(themeOf(palette()));
    const QRectF plot = area();
    const int line = fontMetrics().height();
    painter.fillRect(rect(), colours.background);
    painter.setPen(QPen(hasFocus() ? colours.secondary : colours.frame, 1.0));
    painter.drawRect(plot);
    for (const int tick : {-4, -2, 0, 2, 4}) {
        const double x = positionOf({static_cast<double>(tick), 0}).x();
        painter.setPen(QPen(colours.grid, 1.0));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(colours.text);
        const QString text = tick < 0 ? QStringLiteral("−%1").arg(-tick) : QString::number(tick);
        painter.drawText(QRectF(x - line, plot.bottom() + 2, 2 * line, line), Qt::AlignCenter, text);
    }
    for (const double tick : {0.0, 0.5, 1.0}) {
        const double y = positionOf({0, tick}).y();
        painter.setPen(colours.text);
        painter.drawText(QRectF(0, y - line / 2.0, plot.left() - 5, line), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(tick));
    }
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(plot.left(), plot.bottom() + 2 + line, plot.width(), line), Qt::AlignCenter,
                     tr("dark side ← position in boundary → bright side"));
    const QColor colour = designColor(themeOf(palette()));
    QPolygonF curve;
    curve << positionOf({-shownPositions, m_nodes.front().opacity});
    for (const EmphasisNode& node : m_nodes) curve << positionOf(node);
    curve << positionOf({shownPositions, m_nodes.back().opacity});
    painter.setPen(QPen(colour, 2.0 * lettersOf(*this)));
    painter.save();
    painter.setClipRect(plot.adjusted(-1, -2, 1, 2));
    painter.drawPolyline(curve);
    painter.restore();
    for (int i = 0; i < static_cast<int>(m_nodes.size()); ++i) {
        const QPointF centre = positionOf(m_nodes[static_cast<std::size_t>(i)]);
        const bool selected = i == m_selected;
        paintNode(painter, centre, inLettersOf(*this, 8), selected ? colour : colours.background, colour);
        if (selected) paintNode(painter, centre, inLettersOf(*this, 14), Qt::transparent, colours.text);
    }
}

void EmphasisCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_selected = nodeAt(event->position());
    m_dragging = m_selected >= 0;
    m_moved = false;
    update();
}

void EmphasisCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragging) return;
    const auto i = static_cast<std::size_t>(m_selected);
    const EmphasisNode wanted = clamped(m_selected, valueAt(event->position()));
    if (wanted == m_nodes[i]) return;
    m_nodes[i] = wanted;
    m_moved = true;
    update();
    emit previewed(m_nodes);
}

void EmphasisCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_dragging = false;
    if (std::exchange(m_moved, false)) emit dragEnded();
}

void EmphasisCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || nodeAt(event->position()) >= 0 || m_nodes.size() >= mostEmphasisNodes)
        return;
    const EmphasisNode added = valueAt(event->position());
    const auto after = std::ranges::upper_bound(m_nodes, added.position, {}, &EmphasisNode::position);
    m_selected = static_cast<int>(after - m_nodes.begin());
    m_nodes.insert(after, added);
    update();
    emit edited(m_nodes, tr("add node of emphasis"));
}

void EmphasisCanvas::removeSelected() {
    if (m_selected < 0 || m_nodes.size() <= fewestNodes) return;
    m_nodes.erase(m_nodes.begin() + m_selected);
    m_selected = std::min(m_selected, static_cast<int>(m_nodes.size()) - 1);
    update();
    emit edited(m_nodes, tr("delete node of emphasis"));
}

bool EmphasisCanvas::select(int step) {
    const int wanted = m_selected < 0 ? (step > 0 ? 0 : static_cast<int>(m_nodes.size()) - 1) : m_selected + step;
    if (wanted < 0 || wanted >= static_cast<int>(m_nodes.size())) return false;
    m_selected = wanted;
    update();
    tellNodeChosen(*this, wanted);
    return true;
}

bool EmphasisCanvas::nudge(int key) {
    if (m_selected < 0) return false;
    EmphasisNode wanted = m_nodes[static_cast<std::size_t>(m_selected)];
    if (key == Qt::Key_Left) wanted.position -= keyStep;
    if (key == Qt::Key_Right) wanted.position += keyStep;
    if (key == Qt::Key_Up) wanted.opacity += keyStep;
    if (key == Qt::Key_Down) wanted.opacity -= keyStep;
    moveSelected(wanted);
    return true;
}

void EmphasisCanvas::moveSelected(const EmphasisNode& wanted) {
    EmphasisNode& node = m_nodes[static_cast<std::size_t>(m_selected)];
    const EmphasisNode next = clamped(m_selected, wanted);
    if (next == node) return;
    node = next;
    update();
    tellNodeChanged(*this, m_selected);
    emit edited(m_nodes, tr("move node of emphasis"));
}

std::vector<SpokenNode> EmphasisCanvas::spokenNodes() const {
    std::vector<SpokenNode> spoken;
    for (int i = 0; i < static_cast<int>(m_nodes.size()); ++i) {
        const EmphasisNode& node = m_nodes[static_cast<std::size_t>(i)];
        spoken.push_back({spokenNameOf(i, m_nodes.size(), tr("position in boundary %1").arg(node.position, 0, 'f', 2)),
                          node.opacity, placeOfNode(positionOf(node), inLettersOf(*this, hitDistance)),
                          i == m_selected});
    }
    return spoken;
}

void EmphasisCanvas::chooseSpokenNode(int node) {
    if (m_dragging) return;
    setFocus(Qt::OtherFocusReason);
    m_selected = node;
    update();
    tellNodeChosen(*this, node);
}

void EmphasisCanvas::setSpokenOpacity(int node, double opacity) {
    if (m_dragging) return;
    m_selected = node;
    update();
    moveSelected({m_nodes[static_cast<std::size_t>(node)].position, opacity});
}

bool EmphasisCanvas::isOwnKey(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
           key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Delete;
}

QSize EmphasisCanvas::sizeHint() const { return inLettersOf(*this, QSize(300, 160)); }

QSize EmphasisCanvas::minimumSizeHint() const { return inLettersOf(*this, QSize(200, 140)); }

void EmphasisCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) updateGeometry();
    QWidget::changeEvent(event);
}

bool EmphasisCanvas::event(QEvent* event) {
    // A focused canvas keeps its own keys.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (isOwnKey(key) || (key == Qt::Key_Escape && m_dragging)) event->accept();
    }
    return QWidget::event(event);
}

bool EmphasisCanvas::focusNextPrevChild(bool next) {
    return select(next ? 1 : -1) || QWidget::focusNextPrevChild(next);
}

void EmphasisCanvas::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key == Qt::Key_Escape && m_dragging) {
        m_dragging = false;
        if (std::exchange(m_moved, false)) emit dragCancelled();
        return;
    }
    if (m_dragging && isOwnKey(key)) return;
    if (key == Qt::Key_Delete) return removeSelected();
    if (key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
        select(key == Qt::Key_PageUp ? -1 : 1);
        return;
    }
    if (!isOwnKey(key) || !nudge(key)) QWidget::keyPressEvent(event);
}

}  // namespace echolucent
