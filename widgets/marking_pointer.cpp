#include "widgets/marking_pointer.h"

#include <QEvent>
#include <QMouseEvent>
#include <utility>

namespace echolucent {

MarkingPointer::MarkingPointer(QObject& watched, Offer offer, QObject* parent)
    : QObject(parent), m_watched(watched), m_offer(std::move(offer)) {
    m_watched.installEventFilter(this);
}

bool MarkingPointer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_watched) return false;
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease: return release(*static_cast<QMouseEvent*>(event));
        case QEvent::Leave: emit left(); return false;
        default: return false;
    }
}

bool MarkingPointer::isNearPress(const QPointF& pixel) const {
    return (pixel - m_pressedAt).manhattanLength() < clickReach;
}

bool MarkingPointer::press(const QMouseEvent& event) {
    if (m_taken == Take::drag) return true;  // another button during a drag
    m_taken = Take::no;
    const Qt::KeyboardModifiers others = Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;
    if (event.button() != Qt::LeftButton || event.buttons() != Qt::LeftButton || (event.modifiers() & others))
        return false;
    m_taken = m_offer(event.position());
    m_pressedAt = event.position();
    if (m_taken == Take::drag) emit pressed(event.position());
    // The widget below must not take the second press for a double click.
    return m_taken == Take::drag || (m_taken == Take::click && event.type() == QEvent::MouseButtonDblClick);
}

bool MarkingPointer::move(const QMouseEvent& event) {
    if (m_taken == Take::drag) {
        emit dragged(event.position());
        return true;
    }
    if (m_taken == Take::click) {
        // The pane must not turn before the pointer has left the place of the press.
        if (isNearPress(event.position())) return true;
        m_taken = Take::no;
    }
    if (event.buttons() == Qt::NoButton) emit hovered(event.position());
    return false;
}

bool MarkingPointer::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return m_taken == Take::drag;
    const Take taken = std::exchange(m_taken, Take::no);
    if (taken == Take::drag) emit released(event.position());
    if (taken == Take::click && isNearPress(event.position())) emit clicked(event.position());
    return taken == Take::drag;
}

}  // namespace echolucent
