// From where the scene is looked at, and how a person's hand moves that. Values in, values out.
#pragma once

#include "processing/picture/camera.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// A camera kept as the angles a person turns, so that orbiting never rolls and the view can be told exactly.
struct CameraPose {
    Viewpoint view;            ///< direction, roll and near cut
    Vec3 focalPoint{0, 0, 0};  ///< grid mm; seen at the picture's centre
    double heightMm = 1.0;     ///< of the picture, in the plane of the focal point, for both projections; > 0
    Projection projection = Projection::parallel;
    friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// The smallest and the largest height of the picture that a zoom reaches: two voxels, and ten times the volume.
struct ZoomLimits {
    double smallestHeightMm = 0.0;
    double largestHeightMm = 0.0;
};
[[nodiscard]] ZoomLimits zoomLimits(const VolumeGeometry& geometry);

/// The camera for the ray caster. In perspective the eye stands where the plane of the focal point has the pose's
/// height.
[[nodiscard]] Camera cameraFor(const CameraPose& pose);

/// The view's box, or the data box where it has none, whole in the picture, seen along the view (see defaultCamera()).
[[nodiscard]] CameraPose fittedPose(const DataBox& box, const Viewpoint& view, Projection projection, double aspect);

/// How far a drag over the picture's height turns.
inline constexpr double degreesPerHeight = 180.0;

/// The pose turned by a drag, in shares of the picture's height, to the right and down: what is in front follows the
/// hand. The height of the picture is half a turn. The axes are the picture's vertical of the beam axis's frame and the
/// picture's horizontal; elevation stops at +-90 degrees; the roll stays.
[[nodiscard]] CameraPose orbited(CameraPose pose, double right, double down);

/// The pose moved across the picture by a drag in shares of the picture's height: the focal plane follows the hand
/// exactly.
[[nodiscard]] CameraPose panned(CameraPose pose, double right, double down);

/// The pose magnified: a factor of 2 shows everything in the focal plane twice as large. The factor is above 0.
[[nodiscard]] CameraPose zoomed(CameraPose pose, double factor, const ZoomLimits& limits);

/// The same about a place in the picture, in shares of its height right of and below its centre: what is seen there in
/// the focal plane stays there.
[[nodiscard]] CameraPose zoomedAbout(const CameraPose& pose, double right, double down, double factor,
                                     const ZoomLimits& limits);

}  // namespace echolucent
