#include "app/window/window_place.h"

#include <QGuiApplication>
#include <QScreen>
#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace echolucent {

namespace {

/// The frame that the desktop puts around a window. Before the window is shown, only a title bar is known of.
QMargins frameOfWindow(const QWidget& window) {
    const QRect whole = window.frameGeometry(), own = window.geometry();
    if (window.isVisible())
        return {own.left() - whole.left(), own.top() - whole.top(), whole.right() - own.right(),
                whole.bottom() - own.bottom()};
    return {0, window.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &window), 0, 0};
}

}  // namespace

QRect inside(const QRect& wanted, const QRect& room) {
    QRect fits(wanted.topLeft(), wanted.size().boundedTo(room.size()));
    fits.moveLeft(std::clamp(fits.left(), room.left(), room.right() + 1 - fits.width()));
    fits.moveTop(std::clamp(fits.top(), room.top(), room.bottom() + 1 - fits.height()));
    return fits;
}

void keepOnScreen(QWidget& window) {
    if (window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen)) return;
    const QScreen* screen = QGuiApplication::screenAt(window.geometry().center());
    if (screen == nullptr) screen = QGuiApplication::primaryScreen();
    if (screen == nullptr) return;
    const QMargins frame = frameOfWindow(window);
    const QRect whole = window.geometry().marginsAdded(frame);
    const QRect fits = inside(whole, screen->availableGeometry());
    if (fits.size() != whole.size()) window.resize(fits.marginsRemoved(frame).size());
    // The desktop finds a place for a window that nobody has placed.
    const bool placed = window.isVisible() || window.testAttribute(Qt::WA_Moved);
    if (placed && fits.topLeft() != whole.topLeft()) window.move(fits.topLeft());
}

}  // namespace echolucent
