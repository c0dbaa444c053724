// What mouse and keys do to the camera of a picture, the same in the 3D view and in panes that are compared. Shares are
// of the picture's height, to the right and down.
#pragma once

#include <QPointF>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace echolucent {

/// What a drag moves.
enum class CameraDrag { none, orbit, pan, zoom, light };
/// Of the button that is pressed and the keys that are held with it.
[[nodiscard]] CameraDrag cameraDragOf(const QMouseEvent& press);
/// The factor of a drag that zooms, by how far it went down; above 1 things grow.
[[nodiscard]] double zoomOfDrag(double down);
/// The factor of a turn of the wheel; 1 where it did not turn up or down.
[[nodiscard]] double zoomOfWheel(const QWheelEvent& event);

/// One stroke of a key. Either it zooms, or it moves by shares.
struct CameraKey {
    CameraDrag moves = CameraDrag::none;  ///< orbit, pan or zoom
    QPointF shares{};
    double factor = 1.0;  ///< of a zoom
};
/// No value for a key that moves no camera: + and - zoom, Control and an arrow orbit by a degree, with Shift by ten,
/// Shift and an arrow pan.
[[nodiscard]] std::optional<CameraKey> cameraKeyOf(const QKeyEvent& event);
/// To where an arrow points, of length 1; no value for another key.
[[nodiscard]] std::optional<QPointF> directionOfArrow(int key);

}  // namespace echolucent
