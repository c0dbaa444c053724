#include "widgets/casting/picture_image.h"

#include <cstddef>

namespace echolucent {

QImage imageOf(const Picture& picture) {
    const std::vector<std::uint8_t> rgb = overBackground(picture, {0, 0, 0});
    return QImage(rgb.data(), picture.width, picture.height, 3 * static_cast<qsizetype>(picture.width),
                  QImage::Format_RGB888)
        .copy();
}

QImage imageOf(const ScreenPicture& picture) {
    return QImage(picture.rgba.data(), picture.width, picture.height, 4 * static_cast<qsizetype>(picture.width),
                  QImage::Format_RGBX8888)
        .convertToFormat(QImage::Format_RGB888);
}

std::vector<std::uint8_t> rgbBytesOf(const QImage& image) {
    const QImage coloured = image.convertToFormat(QImage::Format_RGB888);
    const auto row = 3 * static_cast<std::ptrdiff_t>(coloured.width());
    std::vector<std::uint8_t> rgb;
    rgb.reserve(static_cast<std::size_t>(row) * static_cast<std::size_t>(coloured.height()));
    for (int y = 0; y < coloured.height(); ++y)
        rgb.insert(rgb.end(), coloured.constScanLine(y), coloured.constScanLine(y) + row);
    return rgb;
}

}  // namespace echolucent
