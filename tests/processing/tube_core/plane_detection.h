// How well the surfaces of a PlaneVolume are found.
#pragma once

#include <algorithm>
#include <cmath>

#include "plane_volume.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent {

inline AdaptiveOtf adapted(const Volume& volume, const Viewpoint& view = {}, const AdaptiveOtfConfig& config = {}) {
    return adaptOpacity(volume, view, config).value();
}

/// How many tube cores found the plane within `tolerance` units. Only those count whose axis crosses it at least 20
/// units behind the entry, 15 before the exit and 4 from any face: a cell that hangs over the border is not centred on
/// the axis.
struct Found {
    int right = 0, of = 0;
};
inline Found tubesOnPlane(const AdaptiveOtf& result, const PlaneVolume& plane, double tolerance) {
    Found found;
    const VolumeGeometry geometry = plane.geometry();
    const auto axes = tubeAxes(geometry, result.view, result.config.grid, result.config.cells.size);
    for (std::size_t t = 0; t < axes.size(); ++t) {
        if (!axes[t].entryVoxel) continue;
        const Vec3 entryMm = geometry.gridMmFromVoxel(*axes[t].entryVoxel);
        const double expected = plane.toPlane(entryMm, axes[t].directionMm) / geometry.unit();
        if (expected < 20 || expected > *axes[t].lengthUnits - 15) continue;
        const Vec3 crossing = entryMm + axes[t].directionMm * (expected * geometry.unit());
        bool inside = true;
        for (int i = 0; i < 3; ++i)
            inside = inside && std::min(crossing[i] - geometry.boxMinMm()[i], geometry.boxMaxMm()[i] - crossing[i]) >
                                   4 * geometry.unit();
        if (!inside) continue;
        ++found.of;
        const auto& surface = result.tubes[t].surfaceVoxel;
        if (!surface) continue;
        const double seen = (geometry.gridMmFromVoxel(*surface) - entryMm).dot(axes[t].directionMm) / geometry.unit();
        if (std::abs(seen - expected) <= tolerance) ++found.right;
    }
    return found;
}

}  // namespace echolucent
