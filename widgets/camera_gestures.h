// How mouse and keys move the camera, alike in the 3D view and in panes that are compared. Shares are of the picture's
// height, to the right and down.
#pragma once

#include <QPointF>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace echolucent {

enum class CameraDrag { none, orbit, pan, zoom, light };
/// The drag of a pressed button and the keys held with it.
[[nodiscard]] CameraDrag cameraDragOf(const QMouseEvent& press);
/// The zoom factor of a drag, by how far it went down. Above 1 things grow.
[[nodiscard]] double zoomOfDrag(double down);
/// The zoom factor of a turn of the wheel; 1 if it turned neither up nor down.
[[nodiscard]] double zoomOfWheel(const QWheelEvent& event);

/// One stroke of a key. It zooms, or it moves by shares.
struct CameraKey {
    CameraDrag moves = CameraDrag::none;  ///< orbit, pan or zoom
    QPointF shares{};
    double factor = 1.0;  ///< of a zoom
};
/// + and - zoom, Control and an arrow orbit by a degree, with Shift by ten, Shift and an arrow pan. No value for any
/// other key.
[[nodiscard]] std::optional<CameraKey> cameraKeyOf(const QKeyEvent& event);
/// The direction of an arrow key, of length 1; no value for another key.
[[nodiscard]] std::optional<QPointF> directionOfArrow(int key);

}  // namespace echolucent
