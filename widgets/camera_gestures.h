// How mouse and keys move the camera, alike in the 3D view and in panes that are compared. Shares are of the picture's
// height, to the right and down.
#pragma once

#include <QPointF>
#include <optional>
#include <vector>

#include "widgets/accessibility/spoken_widget.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace echolucent {

enum class CameraDrag { none, orbit, pan, zoom, light };
/// What a drag with this button does; the keys held with the button count too.
[[nodiscard]] CameraDrag cameraDragOf(const QMouseEvent& press);
/// The zoom factor of a drag that went down by this share. Above 1, things grow; a drag upwards (`down` below 0)
/// enlarges.
[[nodiscard]] double zoomOfDrag(double down);
/// The zoom factor of a turn of the wheel; 1 if the wheel turned neither up nor down.
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
/// The same keys for screen readers.
[[nodiscard]] std::vector<SpokenAction> cameraActions();
/// The direction of an arrow key, of length 1; no value for another key.
[[nodiscard]] std::optional<QPointF> directionOfArrow(int key);

}  // namespace echolucent
