#include "widgets/controls/over_picture.h"

#include <QEvent>
#include <QWindow>

namespace echolucent {

void OverPicture::setPicture(QWidget& picture) {
    m_picture = &picture;
    setAttribute(Qt::WA_DontCreateNativeAncestors);
    setAttribute(Qt::WA_NativeWindow);
    for (QWidget* around = &picture; around != nullptr; around = around->parentWidget())
        around->installEventFilter(this);
    place();
}

bool OverPicture::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (watched == m_picture && (type == QEvent::Resize || type == QEvent::Move)) place();
    // The picture gets a window of its own only after it is shown, and a click on a dock's tab raises that window. Both
    // would cover this widget, so raise it again.
    if (m_picture != nullptr && (type == QEvent::Show || type == QEvent::ZOrderChange))
        QMetaObject::invokeMethod(this, &OverPicture::place, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

bool OverPicture::event(QEvent* event) {
    const bool taken = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::StyleChange) place();
    return taken;
}

void OverPicture::place() {
    if (m_picture == nullptr || isHidden()) return;
    setGeometry(placeOver({m_picture->mapTo(parentWidget(), QPoint(0, 0)), m_picture->size()}));
    raise();
    // The widget may already be in front while its window is not.
    if (QWindow* own = windowHandle()) own->raise();
}

}  // namespace echolucent
