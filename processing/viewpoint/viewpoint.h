// From where the volume is looked at: beam axis, angles, and what is cut away. One viewpoint serves tube cores and
// rays.
#pragma once

#include <optional>
#include <string_view>

#include "processing/viewpoint/cut_surface.h"
#include "processing/viewpoint/oriented_box.h"
#include "processing/viewpoint/view_frame.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The grid axis along which sound travelled, and which way. The default view looks along this axis.
enum class BeamAxis { plusX, minusX, plusY, minusY, plusZ, minusZ };

/// "+x", "-x", "+y", "-y", "+z", "-z".
[[nodiscard]] std::string_view nameOf(BeamAxis axis);
[[nodiscard]] std::optional<BeamAxis> beamAxisFromName(std::string_view name);

/// A flat front. It is fixed in the volume: all that lies before it, seen along `forward`, is cut away from wherever
/// one looks.
struct FrontPlane {
    Vec3 forward{0, 0, 1};  ///< unit, grid mm
    double depthMm = 0.0;   ///< behind the volume's foremost point along `forward`, >= 0
    friend bool operator==(const FrontPlane&, const FrontPlane&) = default;
};

/// A view direction, and what is cut away of the volume. With beam axis +z the direction is R_y(azimuth) R_x(elevation)
/// (0,0,1), right-handed, on the grid axes in mm. Another beam axis turns that frame first.
struct Viewpoint {
    BeamAxis beamAxis = BeamAxis::plusZ;
    double azimuthDegrees = 0.0;
    double elevationDegrees = 0.0;
    double rollDegrees = 0.0;  ///< turn of the picture about the view direction; tube cores keep their direction
    // These are fixed in the volume and do not turn with the view.
    std::optional<FrontPlane> frontPlane{};  ///< cuts away all before it
    std::optional<CutSurface> cutSurface{};  ///< cuts away all before it
    std::optional<OrientedBox> box{};        ///< cuts away all outside it

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

[[nodiscard]] ViewFrame frameOf(const Viewpoint& view);

/// The view along `forward`, relative to `beamAxis`, of the whole volume. Its roll brings the picture's down as near as
/// possible to `down`. Both vectors have any length above 0 and are not parallel; a zero `forward` throws
/// std::invalid_argument. Azimuth and roll are in [-180, 180] degrees, the elevation in [-90, 90].
[[nodiscard]] Viewpoint viewAlong(const Vec3& forward, const Vec3& down, BeamAxis beamAxis);

/// The view with a flat front across it, `depthMm` behind the volume's foremost point along the view; without one if
/// `depthMm` is 0 or less.
[[nodiscard]] Viewpoint withFrontAcross(Viewpoint view, double depthMm);
/// Whether the view has a flat front that does not lie across it.
[[nodiscard]] bool hasObliqueFront(const Viewpoint& view);
/// FrontPlane::depthMm of the view's flat front; 0 if it has none.
[[nodiscard]] double frontDepthMm(const Viewpoint& view);

/// The view turned about an axis of length 1 in its own frame, right-handed: {1, 0, 0} is the picture's horizontal,
/// {0, 1, 0} its vertical, {0, 0, 1} the direction of looking. Cuts stay where they are. If one angle alone says the
/// turn, the degrees are added to it and the others keep their bits; the elevation may then leave [-90, 90].
[[nodiscard]] Viewpoint turnedAbout(const Viewpoint& view, const Vec3& axis, double degrees);

/// The same view with an elevation in [-90, 90] degrees. If it had one, it keeps its bits.
[[nodiscard]] Viewpoint withinPoles(const Viewpoint& view);

/// The view with angles that are whole degrees where they are so but for rounding, and no angle of -180 degrees. The
/// way through a frame leaves such angles.
[[nodiscard]] Viewpoint withoutRounding(Viewpoint view);

/// The unit view direction in voxel index space (divided by spacing per axis, then normalised).
[[nodiscard]] Vec3 directionInVoxels(const Viewpoint& view, const VolumeGeometry& geometry);

/// Extent of the volume's box along the view, mm. A flat front across the view at this depth leaves nothing.
[[nodiscard]] double depthAlongViewMm(const Viewpoint& view, const VolumeGeometry& geometry);

/// The plane of a flat front in a volume, counted from the grid origin.
[[nodiscard]] CuttingFace cuttingFaceOf(const FrontPlane& front, const VolumeGeometry& geometry);

/// Nothing of the volume is left before this depth along the view, mm from the grid origin. If the view's flat front
/// lies across the view, it is that of the front, else that of the foremost corner of the volume's box.
[[nodiscard]] double nearPlaneDepthMm(const Viewpoint& view, const VolumeGeometry& geometry);

}  // namespace echolucent
