#include "widgets/hand_gesture.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>

namespace echolucent {

HandGesture::HandGesture(QObject* parent, int burstMilliseconds) : QObject(parent) {
    m_burst.setSingleShot(true);
    m_burst.setInterval(burstMilliseconds);
    connect(&m_burst, &QTimer::timeout, this, &HandGesture::end);
    QCoreApplication::instance()->installEventFilter(this);
}

bool HandGesture::eventFilter(QObject*, QEvent* event) {
    // One event passes here once for its window and once for each widget that gets it. Each time may begin a gesture
    // anew, but nothing is edited in between.
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: begin(Kind::button); break;
        case QEvent::MouseMove:
            if (static_cast<QMouseEvent*>(event)->buttons() == Qt::NoButton && m_kind == Kind::button) end();
            break;
        case QEvent::KeyPress:
            // A repeating key is held, even if the release of another key has ended the gesture.
            if (!static_cast<QKeyEvent*>(event)->isAutoRepeat() || !m_open) begin(Kind::key);
            break;
        case QEvent::MouseButtonRelease: endSoon(); break;
        case QEvent::KeyRelease:
            if (!static_cast<QKeyEvent*>(event)->isAutoRepeat()) endSoon();
            break;
        case QEvent::Wheel: goOn(Kind::wheel); break;
        default: break;
    }
    return false;
}

void HandGesture::begin(Kind kind) {
    m_burst.stop();
    m_kind = kind;
    ++m_number;
    m_open = true;
}

void HandGesture::goOn(Kind kind) {
    if (!m_open || m_kind != kind) begin(kind);
    m_burst.start();
}

void HandGesture::endSoon() {
    // Edits by the release itself still belong to the gesture.
    QMetaObject::invokeMethod(
        this,
        [this, number = m_number] {
            if (number == m_number && m_kind != Kind::wheel) end();
        },
        Qt::QueuedConnection);
}

void HandGesture::end() {
    m_burst.stop();
    m_open = false;
    m_kind = Kind::none;
}

}  // namespace echolucent
