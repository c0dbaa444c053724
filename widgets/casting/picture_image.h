// Pictures of the ray caster as images of Qt, and images as bytes of pictures.
#pragma once

#include <QImage>
#include <cstdint>
#include <vector>

#include "processing/picture/picture.h"
#include "processing/picture/screen_picture.h"

namespace echolucent {

/// The picture over black, 8-bit red, green and blue.
[[nodiscard]] QImage imageOf(const Picture& picture);
[[nodiscard]] QImage imageOf(const ScreenPicture& picture);

/// The image's red, green and blue, one byte each, rows from the top without gaps between them.
[[nodiscard]] std::vector<std::uint8_t> rgbBytesOf(const QImage& image);

}  // namespace echolucent
