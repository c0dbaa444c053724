// A picture in grey, coloured by what it does with the surfaces that are known.
#pragma once

#include <QImage>
#include <cstdint>
#include <span>

#include "processing/comparison/shown_depth.h"

namespace echolucent {

/// `rays` are raysInPicture() of the picture's size, and `shown` what the picture does with each ray's surface. A pixel
/// of a ray has surfaceShade(), any other its grey level. Throws std::invalid_argument if there is not one of `rays`
/// for each pixel.
[[nodiscard]] QImage colouredSurfaces(const QImage& picture, std::span<const std::int32_t> rays,
                                      std::span<const ShownSurface> shown);

}  // namespace echolucent
