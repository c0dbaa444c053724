// Pixels half-way between rays: which of them need a ray of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/picture/picture.h"
#include "processing/ray_caster/ray_geometry.h"

namespace echolucent::ray_casting {

/// How far apart the first rays of a picture are, pixels: 4, 2 or 1, if neighbouring pixels are so many units apart.
/// The rays are a unit apart at most, else whole voxels between them would hardly be seen.
[[nodiscard]] constexpr int raysApart(double pixelUnits) {
    int apart = 4;
    while (apart > 1 && !(apart * pixelUnits <= 1.0)) apart /= 2;
    return apart;
}

/// What is left to cast of a picture.
struct PixelsLeft {
    std::vector<std::uint8_t> chosen;  ///< not 0 where a ray must be cast; row-major
    std::size_t count = 0;             ///< of them
};

/// Fills pixels half-way between rays. The picture has the pixels of each `apart`-th column and row, an even number.
/// Between two of them the mean of both errs by an eighth of the second difference, if the picture is smooth there.
/// Where that is at most `tolerance` on both sides, in levels of 255 of every channel, the pixel gets the mean. A pixel
/// amid four of them gets the mean of the four, if the pixels on all its sides were filled. All other pixels half-way
/// within the box are left to cast.
[[nodiscard]] PixelsLeft fillBetweenRays(Picture& picture, const RayGeometry::PixelBox& box, int apart,
                                         double tolerance);

}  // namespace echolucent::ray_casting
