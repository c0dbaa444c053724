// Where the window stands: inside its screen, whatever that is.
#pragma once

#include <QRect>
#include <QSize>

class QWidget;

namespace echolucent {

/// The size of the window at the first start if the screen has room for it: logical pixels, without the frame.
inline constexpr QSize roomySize{1440, 920};

/// The rectangle `wanted`, made smaller and moved until it fits into `room`. If it fits, it stays as it is.
[[nodiscard]] QRect inside(const QRect& wanted, const QRect& room);

/// Makes a window no larger than its screen has room for, its frame included, and moves it there if somebody has placed
/// it. A window that fits stays as it is, and so does one that is maximised or full screen.
void keepOnScreen(QWidget& window);

}  // namespace echolucent
