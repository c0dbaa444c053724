#include "widgets/volume_view/view_pointer.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>

namespace echolucent {

QList<QUrl> filesIn(const QMimeData* data) { return data != nullptr ? data->urls() : QList<QUrl>(); }

ViewPointer::ViewPointer(QWindow* window, QObject* parent) : QObject(parent), m_window(window) {
    window->installEventFilter(this);
}

bool ViewPointer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_window) return false;
    switch (event->type()) {
        case QEvent::MouseButtonPress: press(*static_cast<QMouseEvent*>(event)); break;
        case QEvent::MouseButtonDblClick:
            if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) emit doubleClicked();
            break;
        case QEvent::MouseMove: move(*static_cast<QMouseEvent*>(event)); break;
        case QEvent::MouseButtonRelease: release(*static_cast<QMouseEvent*>(event)); break;
        case QEvent::Wheel: turnWheel(*static_cast<QWheelEvent*>(event)); break;
        case QEvent::Leave: emit left(); break;
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
        case QEvent::ShortcutOverride: emit keyPressed(static_cast<QKeyEvent*>(event)); return event->isAccepted();
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop: {
            auto* drop = static_cast<QDropEvent*>(event);
            const QList<QUrl> files = filesIn(drop->mimeData());
            drop->setAccepted(!files.isEmpty());
            if (files.isEmpty()) return true;
            drop->acceptProposedAction();
            if (event->type() == QEvent::Drop) emit filesDropped(files);
            return true;
        }
        default: break;
    }
    return false;
}

bool ViewPointer::cancelDrag() {
    if (!dragging()) return false;
    m_drag = CameraDrag::none;
    emit dragCancelled();
    return true;
}

void ViewPointer::press(const QMouseEvent& event) {
    if (dragging()) return;
    m_drag = cameraDragOf(event);
    if (!dragging()) return;
    m_button = event.button();
    m_last = event.position();
    emit dragStarted();
}

void ViewPointer::move(const QMouseEvent& event) {
    if (!dragging()) {
        if (event.buttons() == Qt::NoButton) emit hovered(event.position());
        return;
    }
    const QPointF moved = (event.position() - m_last) / std::max(1, m_window->height());
    m_last = event.position();
    if (moved.isNull()) return;
    switch (m_drag) {
        case CameraDrag::orbit: emit orbited(moved.x(), moved.y()); break;
        case CameraDrag::pan: emit panned(moved.x(), moved.y()); break;
        case CameraDrag::zoom: emit zoomed(zoomOfDrag(moved.y())); break;
        case CameraDrag::light: emit lightMoved(moved.x(), moved.y()); break;
        case CameraDrag::none: break;
    }
}

void ViewPointer::release(const QMouseEvent& event) {
    if (event.button() != m_button || !dragging()) return;
    m_drag = CameraDrag::none;
    emit dragEnded();
}

void ViewPointer::turnWheel(const QWheelEvent& event) {
    const double factor = zoomOfWheel(event);
    if (factor == 1.0) return;
    const QPointF fromCentre = event.position() - QPointF(m_window->width(), m_window->height()) / 2.0;
    const QPointF shares = fromCentre / std::max(1, m_window->height());
    emit zoomedAbout(shares.x(), shares.y(), factor);
}

}  // namespace echolucent
