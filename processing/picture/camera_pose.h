// The camera as a person moves it.
#pragma once

#include "processing/picture/camera.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// A camera kept as angles, so that the view can be stated exactly.
struct CameraPose {
    Viewpoint view;            ///< direction and roll
    Vec3 focalPoint{0, 0, 0};  ///< grid mm; seen at the picture's centre
    double heightMm = 1.0;     ///< of the picture, in the plane of the focal point, for both projections; > 0
    Projection projection = Projection::parallel;
    friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// The smallest and the largest height of the picture for a zoom: two units, and ten times the diagonal of the volume.
struct ZoomLimits {
    double smallestHeightMm = 0.0;
    double largestHeightMm = 0.0;
};
[[nodiscard]] ZoomLimits zoomLimits(const VolumeGeometry& geometry);

/// The camera for the ray caster. In perspective the eye stands so far away that the picture's height in the focal
/// plane is the pose's.
[[nodiscard]] Camera cameraFor(const CameraPose& pose);

/// The pose along the view that shows the view's box whole, or the data box if the view has none (see defaultCamera()).
[[nodiscard]] CameraPose fittedPose(const DataBox& box, const Viewpoint& view, Projection projection, double aspect);

/// How far a drag over the picture's height turns the view.
inline constexpr double degreesPerHeight = 180.0;

/// Turns the pose by a drag to the right and down, in shares of the picture's height. The front of the scene follows
/// the hand. The picture's height is half a turn. The axis lies in the picture, goes through its centre and stands
/// across the drag: the picture's vertical for a drag sideways, its horizontal for one up or down. So every direction
/// of looking turns alike, the poles among them, and drags that go round a curve may leave the picture rolled.
[[nodiscard]] CameraPose orbited(CameraPose pose, double right, double down);

/// Moves the pose across the picture by a drag, in shares of the picture's height. The focal plane follows the hand
/// exactly.
[[nodiscard]] CameraPose panned(CameraPose pose, double right, double down);

/// Magnifies. A factor of 2 shows everything in the focal plane twice as large. The factor is above 0. The picture's
/// height stays within `limits`.
[[nodiscard]] CameraPose zoomed(CameraPose pose, double factor, const ZoomLimits& limits);

/// Magnifies about a place in the picture, in shares of its height right of and below its centre. The point of the
/// focal plane at that place stays there.
[[nodiscard]] CameraPose zoomedAbout(const CameraPose& pose, double right, double down, double factor,
                                     const ZoomLimits& limits);

}  // namespace echolucent
