// Volumes so small that what a ray shows can be worked out by hand.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/classification.h"
#include "processing/phantom/phantom.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/volume/volume.h"

namespace echolucent {

inline constexpr std::int64_t width = 6, depth = 40;
inline constexpr int surfaceSlice = 20;
/// The true surface lies between slices 19 and 20.
inline constexpr double surfaceDepth = surfaceSlice - 0.5;

inline VolumeGeometry smallGeometry() {
    VolumeGeometry geometry;
    geometry.size = {width, width, depth};
    return geometry;
}

/// The voxels hold `before` up to the surface and `behind` from it on.
inline Volume twoLayers(std::uint8_t before, std::uint8_t behind) {
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(width * width * depth), before);
    std::fill(voxels.begin() + width * width * surfaceSlice, voxels.end(), behind);
    return {smallGeometry(), voxels};
}

inline OpacityCurve constantOpacity(double opacity) { return ManualCurve{{{0.0, opacity}}}; }

/// Opacity in proportion to the gradient magnitude, at any intensity: 1 at `largest`.
inline Classification opacityOfGradient(double largest) {
    return Classification(TwoDimensionalOtf{2, 2, largest, {0.0f, 0.0f, 1.0f, 1.0f}});
}

inline PhantomConfig smallShapes() {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {64, 60, 66};
    return config;
}

/// One tube core along z through the middle of a volume, with its surface in a given slice.
inline AdaptiveOtf oneTube(double slice, double d) {
    AdaptiveOtf otf;
    otf.config.grid.columns = otf.config.grid.rows = 1;
    otf.config.grid.spacing = 5;
    TubeCore tube;
    tube.status = TubeStatus::surface;
    const Vec3 middle = tubeAxes(smallGeometry(), {}, otf.config.grid, otf.config.cells.size).front().pointMm;
    tube.entryVoxel = Vec3(middle[0], middle[1], -0.5);
    tube.firstSampleVoxel = Vec3(middle[0], middle[1], 0);
    tube.surfaceVoxel = Vec3(middle[0], middle[1], slice);
    tube.d = d;
    otf.tubes = {tube};
    return otf;
}

}  // namespace echolucent
