// Mouse, wheel and dropped files over the 3D view's OpenGL window, in the picture's measures.
#pragma once

#include <QList>
#include <QObject>
#include <QPointF>
#include <QUrl>

#include "widgets/camera_gestures.h"

class QKeyEvent;
class QMimeData;
class QMouseEvent;
class QWheelEvent;
class QWindow;

namespace echolucent {

/// The addresses of dragged files; empty if there are none.
[[nodiscard]] QList<QUrl> filesIn(const QMimeData* data);

/// Left drag orbits, middle or Shift + left drag pans, right drag and the wheel zoom, Ctrl + left drag moves the light.
/// Drags are signalled as they go, to the right and down, in shares of the window's height. Whoever gets Escape calls
/// cancelDrag(). Mouse and wheel events also pass on. Keys pass on unless a receiver of keyPressed() accepts them.
/// Dragged and dropped data goes no further.
class ViewPointer : public QObject {
    Q_OBJECT

public:
    explicit ViewPointer(QWindow* window, QObject* parent = nullptr);
    [[nodiscard]] bool dragging() const { return m_drag != CameraDrag::none; }
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Ends a drag without change; false if there is none.
    bool cancelDrag();

signals:
    void dragStarted();
    void dragEnded();  ///< the hand has let go
    void dragCancelled();
    void orbited(double right, double down);
    void panned(double right, double down);
    void zoomed(double factor);  ///< above 1 things grow; about the picture's centre
    /// Zooms by `factor` about a point, in shares of the window's height from the picture's centre.
    void zoomedAbout(double right, double down, double factor);
    void lightMoved(double right, double down);
    void hovered(const QPointF& position);  ///< logical pixels from the window's top left corner; no button is held
    void left();
    void doubleClicked();               ///< with the left button
    void keyPressed(QKeyEvent* event);  ///< also releases and shortcut overrides; for the widget with the focus
    void filesDropped(const QList<QUrl>& files);

private:
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void turnWheel(const QWheelEvent& event);

    QWindow* m_window;
    CameraDrag m_drag = CameraDrag::none;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_last;
};

}  // namespace echolucent
