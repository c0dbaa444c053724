#include "widgets/compare/difference_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace echolucent {

namespace {
constexpr int levels = 256;
constexpr int grey = 128;  // if both are alike
}  // namespace

DifferenceImage differenceOf(const QImage& first, const QImage& second, double amplification) {
    if (first.size() != second.size() || first.isNull()) return {};
    const QImage one = first.convertToFormat(QImage::Format_RGB888),
                 two = second.convertToFormat(QImage::Format_RGB888);
    std::array<uchar, 2 * levels> shown{};
    for (int i = 0; i < 2 * levels; ++i)
        shown[static_cast<std::size_t>(i)] =
            static_cast<uchar>(std::clamp(std::lround(grey + amplification * (i - levels)), 0L, 255L));
    DifferenceImage difference{QImage(one.size(), QImage::Format_RGB888)};
    std::int64_t squares = 0;
    for (int y = 0; y < one.height(); ++y) {
        const uchar* a = one.constScanLine(y);
        const uchar* b = two.constScanLine(y);
        uchar* line = difference.image.scanLine(y);
        for (int x = 0; x < 3 * one.width(); ++x) {
            const int difference8 = a[x] - b[x];
            squares += static_cast<std::int64_t>(difference8) * difference8;
            line[x] = shown[static_cast<std::size_t>(difference8 + levels)];
        }
    }
    difference.rmse = std::sqrt(static_cast<double>(squares) / (3.0 * one.width() * one.height()));
    return difference;
}

}  // namespace echolucent
