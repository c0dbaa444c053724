// A picture as the ray caster makes it.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

/// Row-major from the top left, four floats a pixel: red, green, blue premultiplied by alpha, then alpha; all in [0,1].
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgba;
    /// Depth of each pixel along camera.frame.forward from the grid origin, mm, if RayCastSettings::findDepth is set;
    /// else empty. Direct: of the sample at which the accumulated opacity reaches one half; maximum and minimum: of the
    /// sample shown; mean: of the first. Infinity if there is no such sample.
    std::vector<float> depthMm{};
};

/// A picture without anything in it. If it has depths, all of them are infinite.
[[nodiscard]] Picture emptyPicture(int width, int height, bool withDepth = false);

/// Mixes in another picture of the same size: `share` parts of `other` with 1 - share parts of `picture`. Depths stay.
void mixIn(Picture& picture, const Picture& other, double share);

/// Multiplies colours by a factor above 0. No colour becomes brighter than white at its alpha. Depths stay.
void brighten(Picture& picture, double factor);

/// The picture over an opaque background (eq. 3's c(r,0)) as 8-bit RGB, rows from the top, three bytes a pixel.
[[nodiscard]] std::vector<std::uint8_t> overBackground(const Picture& picture, const Vec3& background);

}  // namespace echolucent
