// Measures the time to bring pictures to the screen, and how many a second are seen.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <optional>

class QOpenGLWindow;

namespace echolucent {

/// Watches an OpenGL window that draws in two steps. The window's owner draws the scene into a frame buffer and calls
/// rendered(). When the window system asks for it, that frame buffer goes onto the screen.
class FrameMeter : public QObject {
    Q_OBJECT

public:
    explicit FrameMeter(QOpenGLWindow* window, QObject* parent = nullptr);
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// A new picture is in the frame buffer. Drawing it took `milliseconds`. `followsHand`: the picture belongs to a
    /// movement.
    void rendered(double milliseconds, bool followsHand);

    /// Both steps of the newest picture on the screen, without the wait between them; 0 before the first.
    [[nodiscard]] double drawingMilliseconds() const { return m_drawing; }
    /// Whether a drawn picture is not on the screen yet.
    [[nodiscard]] bool waitsForScreen() const { return m_rendered.has_value(); }
    /// Pictures a second of the newest movement, as a running mean; empty before the first.
    [[nodiscard]] std::optional<double> framesPerSecond() const;

signals:
    /// A new picture is on the screen. `milliseconds` is drawingMilliseconds().
    void pictureDrawn(double milliseconds);

private:
    void swapped();
    void learnInterval();

    QOpenGLWindow* m_window;
    std::optional<double> m_rendered;  // ms, of the picture that is not on the screen yet
    bool m_followsHand = false;
    QElapsedTimer m_sinceUpdate;
    QElapsedTimer m_sincePicture;
    double m_drawing = 0.0;
    double m_interval = 0.0;  // ms; 0 if not known
    int m_intervals = 0;      // of the newest movement
};

}  // namespace echolucent
