// A pointer that the last row of a class sees.
#pragma once

#include <QCursor>
#include <QObject>

namespace echolucent {

/// A ring with a dot in its middle, light within dark, so that it stands out on any picture. Its hot spot is the dot.
[[nodiscard]] QCursor largePointer(double pixelRatio);
/// The ring's outer diameter, logical pixels.
inline constexpr int largePointerSize = 88;

/// Shows the large pointer over all windows of the program, in the place of every other cursor. The cursors are back
/// once it is switched off or destroyed.
class LargePointer : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~LargePointer() override { show(false); }

    void show(bool shown);
    [[nodiscard]] bool shown() const { return m_shown; }

private:
    bool m_shown = false;
};

}  // namespace echolucent
