#include "widgets/marking_pointer.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMouseEvent>
#include <utility>

namespace echolucent {

MarkingPointer::MarkingPointer(QObject& watched, Offer offer, QObject* parent)
    : QObject(parent), m_watched(watched), m_offer(std::move(offer)) {
    m_watched.installEventFilter(this);
}

bool MarkingPointer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_watched || m_passesPressOn) return false;
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
    m_pressedAtGlobal = event.globalPosition();
    if (m_taken == Take::clickAlone && event.type() == QEvent::MouseButtonDblClick) {
        m_taken = Take::no;
        return false;
    }
    if (m_taken == Take::drag) emit pressed(event.position());
    // The widget below must not take the second press for a double click.
    return m_taken == Take::drag || m_taken == Take::clickAlone ||
           (m_taken == Take::click && event.type() == QEvent::MouseButtonDblClick);
}

/// Sends the press that was withheld, because a drag has begun there.
void MarkingPointer::passPressOn() {
    QMouseEvent press(QEvent::MouseButtonPress, m_pressedAt, m_pressedAtGlobal, Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    m_passesPressOn = true;
    QCoreApplication::sendEvent(&m_watched, &press);
    m_passesPressOn = false;
}

bool MarkingPointer::move(const QMouseEvent& event) {
    if (m_taken == Take::drag) {
        emit dragged(event.position());
        return true;
    }
    if (m_taken == Take::click || m_taken == Take::clickAlone) {
        // The pane must not turn before the pointer has left the place of the press.
        if (isNearPress(event.position())) return true;
        if (std::exchange(m_taken, Take::no) == Take::clickAlone) passPressOn();
    }
    if (event.buttons() == Qt::NoButton) emit hovered(event.position());
    return false;
}

bool MarkingPointer::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return m_taken == Take::drag;
    const Take taken = std::exchange(m_taken, Take::no);
    if (taken == Take::drag) emit released(event.position());
    const bool click = taken == Take::click || taken == Take::clickAlone;
    if (click && isNearPress(event.position())) emit clicked(event.position());
    return taken == Take::drag || taken == Take::clickAlone;
}

}  // namespace echolucent
