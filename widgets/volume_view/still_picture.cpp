#include "widgets/volume_view/still_picture.h"

#include <QEvent>
#include <QPainter>
#include <QWindow>

namespace echolucent {

StillPicture::StillPicture(QWidget& view) : QWidget(&view) {
    // An OpenGL window covers what Qt draws into its window, but not another native window above it.
    setAttribute(Qt::WA_DontCreateNativeAncestors);
    setAttribute(Qt::WA_NativeWindow);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::NoFocus);
    hide();
    view.installEventFilter(this);
}

void StillPicture::showImage(const QImage& image) {
    m_image = image;
    setGeometry(parentWidget()->rect());
    show();
    raise();
    // The widget may be the foremost one even if its window is not.
    if (QWindow* own = windowHandle()) own->raise();
    update();
}

bool StillPicture::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void StillPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    // The view's shape may have changed since the image was made. Round things stay round.
    QRect place(QPoint(), m_image.size().scaled(size(), Qt::KeepAspectRatio));
    place.moveCenter(rect().center());
    painter.fillRect(rect(), Qt::black);
    painter.drawImage(place, m_image);
}

}  // namespace echolucent
