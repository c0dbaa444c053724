// From where the volume is looked at: beam axis, angles, cuts. Tube cores and rays share it.
#pragma once

#include <optional>
#include <string_view>

#include "processing/viewpoint/cut_surface.h"
#include "processing/viewpoint/oriented_box.h"
#include "processing/viewpoint/view_frame.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Which way along which grid axis sound travelled: the default view direction.
enum class BeamAxis { plusX, minusX, plusY, minusY, plusZ, minusZ };

/// "+x", "-x", "+y", "-y", "+z", "-z".
[[nodiscard]] std::string_view nameOf(BeamAxis axis);
[[nodiscard]] std::optional<BeamAxis> beamAxisFromName(std::string_view name);

/// A view direction and what is cut off in front. With beam axis +z the direction is
/// R_y(azimuth) R_x(elevation) (0,0,1), right-handed, on the grid axes in mm; another beam axis turns that frame first.
struct Viewpoint {
    BeamAxis beamAxis = BeamAxis::plusZ;
    double azimuthDegrees = 0.0;
    double elevationDegrees = 0.0;
    double rollDegrees = 0.0;  ///< turn of the picture about the view direction; moves no tube core's axis direction
    double nearCutMm = 0.0;    ///< nothing nearer than this behind the volume's foremost point along the view; >= 0
    std::optional<CutSurface> cutSurface{};  ///< what lies before it is cut away too; it does not turn with the view
    std::optional<OrientedBox> box{};        ///< what lies outside it is cut away too; it does not turn with the view

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

[[nodiscard]] ViewFrame frameOf(const Viewpoint& view);

/// The view whose frame's forward (and, through roll, down) is the given one, relative to a beam axis: what "compute
/// for this view" needs. Both vectors have any length above 0 and are not parallel. Angles are in (-180, 180], the
/// elevation in [-90, 90].
[[nodiscard]] Viewpoint viewAlong(const Vec3& forward, const Vec3& down, BeamAxis beamAxis, double nearCutMm);

/// The unit view direction in voxel index space (divided by spacing per axis, then normalised).
[[nodiscard]] Vec3 directionInVoxels(const Viewpoint& view, const VolumeGeometry& geometry);

/// How deep the volume's box is along the view, mm. A near cut at this depth leaves nothing.
[[nodiscard]] double depthAlongViewMm(const Viewpoint& view, const VolumeGeometry& geometry);

/// Distance along `forward` (mm, measured from the grid origin) of the near cut plane: the foremost corner of the box
/// plus nearCutMm.
[[nodiscard]] double nearPlaneDepthMm(const Viewpoint& view, const VolumeGeometry& geometry);

}  // namespace echolucent
