// Volumes so small that what a ray shows can be worked out by hand.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "processing/classification.h"
#include "processing/comparison/classification_measures.h"
#include "processing/phantom/phantom.h"
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

/// A ray along z through the middle of a volume, with its surface at a depth.
inline std::vector<SurfaceRay> oneRay(double surfaceDepthMm) {
    return {{.pointMm = Vec3(2.5, 2.5, 0), .surfaceDepthMm = surfaceDepthMm}};
}

/// There is one ray through each voxel of the front face.
inline std::vector<SurfaceRay> allRays() {
    std::vector<SurfaceRay> rays;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) rays.push_back({.pointMm = Vec3(x, y, 0), .surfaceDepthMm = surfaceDepth});
    return rays;
}

/// The measures of one classification.
inline ClassificationMeasures measured(const Volume& volume, const Viewpoint& view, const std::vector<SurfaceRay>& rays,
                                       const Classification& classification) {
    return measuresOf(volume, view, rays, std::span(&classification, 1))->front();
}

}  // namespace echolucent
