// A coloured frame around a control of the window: what a lesson's step looks at.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <array>

namespace echolucent {

/// Four strips around a widget of the window. Each has a native window of its own, because nothing else can be drawn
/// over the OpenGL window of the 3D view. They take no mouse and move nothing. Objects: lessons.outline.0 to .3 (top,
/// bottom, left, right).
class LessonOutline : public QObject {
    Q_OBJECT

public:
    /// The window outlives this object.
    explicit LessonOutline(QWidget& window);
    ~LessonOutline() override;

    /// Outlines a widget of the window, or nothing. The frame follows it, and is away while it is not seen.
    void lieAround(QWidget* target);
    [[nodiscard]] QWidget* target() const { return m_target; }
    /// The frame's outer edge, in the window's coordinates. The frame lies around the target. If the target fills the
    /// widget around it, the frame lies within the target. Empty if nothing of the target is seen.
    [[nodiscard]] QRect rectangle() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

    /// The width of the strips, pixels.
    static constexpr int width = 3;

private:
    void follow(bool watches);
    void place();

    QWidget& m_window;
    QPointer<QWidget> m_target;
    std::array<QPointer<QWidget>, 4> m_strips;
};

}  // namespace echolucent
