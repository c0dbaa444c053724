#include "widgets/volume_view/lasso_pointer.h"

#include <QMouseEvent>
#include <QWindow>
#include <algorithm>
#include <utility>

namespace echolucent {

namespace {
constexpr double leastMove = 2.0;  // logical pixels between the places of a freehand line
}

LassoPointer::LassoPointer(QWindow* window, QObject* parent) : QObject(parent), m_window(window) {
    window->installEventFilter(this);
}

void LassoPointer::setTool(std::optional<ScalpelTool> tool) {
    cancelDrawing();
    m_tool = tool;
    emit toolChanged();
}

bool LassoPointer::cancelDrawing() {
    if (!std::exchange(m_drawing, false)) return false;
    m_places.clear();
    emit drawn({});
    return true;
}

bool LassoPointer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_window || !m_tool) return false;
    switch (event->type()) {
        case QEvent::MouseButtonPress: return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease: return release(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonDblClick:
            // The first click of the two has set the last corner.
            if (static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return false;
            if (m_tool == ScalpelTool::polygon) closePolygon();
            return true;
        default: return false;
    }
}

PicturePlace LassoPointer::placeOf(const QPointF& pixel) const {
    const double height = std::max(1, m_window->height());
    return {(pixel.x() - m_window->width() / 2.0) / height, (pixel.y() - m_window->height() / 2.0) / height};
}

void LassoPointer::add(const QPointF& pixel) {
    m_last = pixel;
    m_places.push_back(placeOf(pixel));
}

bool LassoPointer::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    if (m_tool != ScalpelTool::polygon || !m_drawing) m_places.clear();
    m_drawing = true;
    add(event.position());
    if (m_tool == ScalpelTool::box) m_places.assign(4, m_places.front());
    emit drawn(m_places);
    return true;
}

bool LassoPointer::move(const QMouseEvent& event) {
    if (!m_drawing) return false;
    if (m_tool == ScalpelTool::polygon) {
        // The line to the cursor is shown, but is no corner yet.
        std::vector<PicturePlace> shown = m_places;
        shown.push_back(placeOf(event.position()));
        emit drawn(shown);
        return true;
    }
    if (!event.buttons().testFlag(Qt::LeftButton)) return true;
    if (m_tool == ScalpelTool::box) {
        const PicturePlace from = m_places.front(), to = placeOf(event.position());
        m_places = {from, {to[0], from[1]}, to, {from[0], to[1]}};
    } else if ((event.position() - m_last).manhattanLength() >= leastMove) {
        add(event.position());
    }
    emit drawn(m_places);
    return true;
}

bool LassoPointer::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !m_drawing) return false;
    if (m_tool != ScalpelTool::polygon) finish();
    return true;
}

bool LassoPointer::closePolygon() {
    if (m_tool != ScalpelTool::polygon || !m_drawing || m_places.size() < 3) return false;
    finish();
    return true;
}

void LassoPointer::finish() {
    m_drawing = false;
    const std::vector<PicturePlace> places = std::exchange(m_places, {});
    emit drawn({});
    const bool flat = m_tool == ScalpelTool::box && (places[0][0] == places[2][0] || places[0][1] == places[2][1]);
    const bool complete = m_tool == ScalpelTool::eraser || (places.size() >= 3 && !flat);
    if (complete) emit finished(places);
}

}  // namespace echolucent
