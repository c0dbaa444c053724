#include "widgets/volume_view/grip_pointer.h"

#include <QMouseEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/picture/picture_place.h"

namespace echolucent {

GripPointer::GripPointer(QWindow* window, std::function<Camera()> camera, QObject* parent)
    : QObject(parent), m_window(window), m_camera(std::move(camera)) {
    window->installEventFilter(this);
}

void GripPointer::setGrips(std::vector<Vec3> gripsMm) {
    m_gripsMm = std::move(gripsMm);
    if (!m_gripsMm.empty()) return;
    cancelDrag();
    setHovering(false);
}

void GripPointer::setCursorBeside(Qt::CursorShape cursor) {
    m_cursorBeside = cursor;
    if (!m_hovering) m_window->setCursor(cursor);
}

void GripPointer::setHovering(bool hovering) {
    if (std::exchange(m_hovering, hovering) == hovering) return;
    m_window->setCursor(hovering ? Qt::OpenHandCursor : m_cursorBeside);
}

bool GripPointer::cancelDrag() {
    if (!std::exchange(m_held, std::nullopt)) return false;
    emit dragCancelled();
    return true;
}

std::optional<std::size_t> GripPointer::gripAt(const QPointF& pixel) const {
    const Camera camera = m_camera();
    const double height = std::max(1, m_window->height());
    for (std::size_t i = 0; i < m_gripsMm.size(); ++i) {
        const auto place = placeInPicture(camera, m_gripsMm[i]);
        if (!place) continue;
        const double right = m_window->width() / 2.0 + (*place)[0] * height - pixel.x();
        const double down = m_window->height() / 2.0 + (*place)[1] * height - pixel.y();
        if (std::hypot(right, down) <= reach) return i;
    }
    return std::nullopt;
}

Vec3 GripPointer::placeAt(const QPointF& pixel, double depthMm) const {
    const double height = std::max(1, m_window->height());
    return gridPlaceAt(
        m_camera(), {(pixel.x() - m_window->width() / 2.0) / height, (pixel.y() - m_window->height() / 2.0) / height},
        depthMm);
}

bool GripPointer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_window || (m_gripsMm.empty() && !m_held)) return false;
    // While a grip is held, nothing else moves the camera.
    if (m_held && event->type() == QEvent::Wheel) return true;
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    if (mouse == nullptr) return false;
    switch (event->type()) {
        case QEvent::MouseButtonPress: {
            if (m_held) return true;
            if (mouse->button() != Qt::LeftButton || mouse->modifiers() != Qt::NoModifier) return false;
            m_held = gripAt(mouse->position());
            if (!m_held) return false;
            m_from = mouse->position();
            m_depthMm = m_camera().frame.forward.dot(m_gripsMm[*m_held]);
            emit dragStarted(*m_held);
            return true;
        }
        case QEvent::MouseMove:
            if (m_held) {
                emit dragged(*m_held, placeAt(mouse->position(), m_depthMm) - placeAt(m_from, m_depthMm));
                return true;
            }
            if (mouse->buttons() == Qt::NoButton) setHovering(gripAt(mouse->position()).has_value());
            return false;
        case QEvent::MouseButtonRelease:
            if (!m_held) return false;
            if (mouse->button() != Qt::LeftButton) return true;
            m_held.reset();
            emit dragEnded();
            return true;
        default: return false;
    }
}

}  // namespace echolucent
