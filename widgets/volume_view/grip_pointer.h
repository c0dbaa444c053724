// Lets the hand hold and drag places over the 3D view.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>
#include <vector>

#include "processing/picture/camera.h"

class QWindow;

namespace echolucent {

/// A left drag without modifier keys that begins on a grip drags the grip. Meanwhile presses, moves, releases and wheel
/// turns go no further. All other events pass on. Whoever gets Escape calls cancelDrag(), which ends a drag without
/// change.
class GripPointer : public QObject {
    Q_OBJECT

public:
    /// `camera` gives the camera of the picture that is shown.
    GripPointer(QWindow* window, std::function<Camera()> camera, QObject* parent = nullptr);

    /// Places of the grid, mm; those in front come first. An empty list ends a drag without change.
    void setGrips(std::vector<Vec3> gripsMm);
    /// The window's cursor beside all grips, at first an arrow. Over a grip it is an open hand.
    void setCursorBeside(Qt::CursorShape cursor);
    [[nodiscard]] bool dragging() const { return m_held.has_value(); }
    /// False if there is no drag.
    bool cancelDrag();

    bool eventFilter(QObject* watched, QEvent* event) override;

    /// A grip is held within this many logical pixels.
    static constexpr double reach = 9.0;

signals:
    void dragStarted(std::size_t grip);
    /// The way from where the drag began to the hand: grid mm, in the plane through the grip across the view.
    void dragged(std::size_t grip, const echolucent::Vec3& mm);
    void dragEnded();
    void dragCancelled();

private:
    [[nodiscard]] std::optional<std::size_t> gripAt(const QPointF& pixel) const;
    void setHovering(bool hovering);
    [[nodiscard]] Vec3 placeAt(const QPointF& pixel, double depthMm) const;

    QWindow* m_window;
    std::function<Camera()> m_camera;
    std::vector<Vec3> m_gripsMm;
    std::optional<std::size_t> m_held;
    bool m_hovering = false;
    Qt::CursorShape m_cursorBeside = Qt::ArrowCursor;
    QPointF m_from;
    double m_depthMm = 0.0;  ///< of the grip when the drag began
};

}  // namespace echolucent
