#include "widgets/compare/coloured_surfaces.h"

#include <array>
#include <cstddef>
#include <stdexcept>

#include "processing/comparison/surface_picture.h"
#include "processing/parallel.h"
#include "widgets/surface_colours.h"

namespace echolucent {

namespace {

constexpr int patternPeriod = 12;  // of all patterns, along rows and columns
constexpr int greyLevels = 256;

/// Every shade that a pixel can have, so that a large picture takes no time.
class Shades {
public:
    Shades() {
        for (const ShownSurface shown : allShownSurfaces)
            for (int place = 0; place < patternPeriod * patternPeriod; ++place)
                for (int grey = 0; grey < greyLevels; ++grey)
                    m_shades.at(index(shown, place / patternPeriod, place % patternPeriod, grey)) =
                        surfaceShade(shown, grey, place % patternPeriod, place / patternPeriod);
    }
    [[nodiscard]] QRgb of(ShownSurface shown, int row, int column, int grey) const {
        return m_shades[index(shown, row % patternPeriod, column % patternPeriod, grey)];
    }

private:
    static std::size_t index(ShownSurface shown, int row, int column, int grey) {
        return ((static_cast<std::size_t>(shown) * patternPeriod + static_cast<std::size_t>(row)) * patternPeriod +
                static_cast<std::size_t>(column)) *
                   greyLevels +
               static_cast<std::size_t>(grey);
    }
    std::array<QRgb, allShownSurfaces.size() * patternPeriod * patternPeriod * greyLevels> m_shades{};
};

}  // namespace

QImage colouredSurfaces(const QImage& picture, std::span<const std::int32_t> rays,
                        std::span<const ShownSurface> shown) {
    static const Shades shades;
    const auto width = static_cast<std::size_t>(picture.width());
    if (rays.size() != width * static_cast<std::size_t>(picture.height()))
        throw std::invalid_argument("colouredSurfaces: one ray a pixel");
    QImage image = picture.convertToFormat(QImage::Format_RGB32);
    uchar* const bytes = image.bits();
    const auto bytesOfRow = static_cast<std::size_t>(image.bytesPerLine());
    parallelFor(0, image.height(), [&](int row) {
        auto* line = reinterpret_cast<QRgb*>(bytes + static_cast<std::size_t>(row) * bytesOfRow);
        for (std::size_t column = 0; column < width; ++column) {
            const int grey = qGray(line[column]);
            const std::int32_t ray = rays[static_cast<std::size_t>(row) * width + column];
            line[column] = ray == noRay
                               ? qRgb(grey, grey, grey)
                               : shades.of(shown[static_cast<std::size_t>(ray)], row, static_cast<int>(column), grey);
        }
    });
    return image;
}

}  // namespace echolucent
