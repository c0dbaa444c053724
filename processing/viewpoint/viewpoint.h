// From where the volume is looked at: beam axis, angles, cuts. One viewpoint serves tube cores and rays.
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

/// A view direction and its cuts. With beam axis +z the direction is R_y(azimuth) R_x(elevation) (0,0,1), right-handed,
/// on the grid axes in mm. Another beam axis turns that frame first.
struct Viewpoint {
    BeamAxis beamAxis = BeamAxis::plusZ;
    double azimuthDegrees = 0.0;
    double elevationDegrees = 0.0;
    double rollDegrees = 0.0;  ///< turn of the picture about the view direction; tube cores keep their direction
    double nearCutMm = 0.0;    ///< mm behind the volume's foremost point along the view: nothing nearer is shown; >= 0
    std::optional<CutSurface> cutSurface{};  ///< cuts away all before it; does not turn with the view
    std::optional<OrientedBox> box{};        ///< cuts away all outside it; does not turn with the view

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

[[nodiscard]] ViewFrame frameOf(const Viewpoint& view);

/// The view along `forward`, relative to `beamAxis`. Its roll brings the picture's down as near as possible to `down`.
/// Both vectors have any length above 0 and are not parallel; a zero `forward` throws std::invalid_argument. Azimuth
/// and roll are in [-180, 180] degrees, the elevation in [-90, 90].
[[nodiscard]] Viewpoint viewAlong(const Vec3& forward, const Vec3& down, BeamAxis beamAxis, double nearCutMm);

/// The unit view direction in voxel index space (divided by spacing per axis, then normalised).
[[nodiscard]] Vec3 directionInVoxels(const Viewpoint& view, const VolumeGeometry& geometry);

/// Extent of the volume's box along the view, mm. A near cut at this depth leaves nothing.
[[nodiscard]] double depthAlongViewMm(const Viewpoint& view, const VolumeGeometry& geometry);

/// Depth of the near cut plane along `forward` of the view, mm from the grid origin: the foremost corner of the
/// volume's box plus nearCutMm (0 if that is negative).
[[nodiscard]] double nearPlaneDepthMm(const Viewpoint& view, const VolumeGeometry& geometry);

}  // namespace echolucent
