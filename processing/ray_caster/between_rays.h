// Pixels between rays of every second column and row: which of them need a ray of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/picture/picture.h"
#include "processing/ray_caster/ray_geometry.h"

namespace echolucent::ray_casting {

/// Distance of the first rays, pixels.
inline constexpr int raysApart = 2;

/// What is left to cast of a picture.
struct PixelsLeft {
    std::vector<std::uint8_t> chosen;  ///< not 0 where a ray must be cast; row-major
    std::size_t count = 0;             ///< of them
};

/// Fills pixels between rays. The picture has the pixels of even columns and rows. Between two of them the mean of both
/// errs by an eighth of the second difference, if the picture is smooth there. Where that is at most `tolerance` on
/// both sides, in levels of 255 of every channel, the pixel gets the mean. A pixel amid four of them gets the mean of
/// the four, if the pixels on all its sides were filled. All other pixels within the box are left to cast.
[[nodiscard]] PixelsLeft fillBetweenRays(Picture& picture, const RayGeometry::PixelBox& box, double tolerance);

}  // namespace echolucent::ray_casting
