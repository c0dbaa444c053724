#include "processing/ray_caster/between_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "processing/parallel.h"

namespace echolucent::ray_casting {

namespace {

constexpr std::ptrdiff_t channels = 4;

/// Makes `out` the mean of the pixels b and c, where a and d are the next ones on either side. False if the mean may
/// err by more than an eighth of `most`.
bool fillMiddle(const float* a, const float* b, const float* c, const float* d, float most, float* out) {
    bool smooth = true;  // not a number is not smooth
    for (std::ptrdiff_t i = 0; i < channels; ++i) {
        const float before = std::abs(a[i] - 2.0f * b[i] + c[i]), behind = std::abs(b[i] - 2.0f * c[i] + d[i]);
        smooth = smooth && before <= most && behind <= most;
    }
    if (!smooth) return false;
    for (std::ptrdiff_t i = 0; i < channels; ++i) out[i] = 0.5f * (b[i] + c[i]);
    return true;
}

}  // namespace

PixelsLeft fillBetweenRays(Picture& picture, const RayGeometry::PixelBox& box, int apart, double tolerance) {
    const std::ptrdiff_t half = apart / 2;
    const std::ptrdiff_t width = picture.width, height = picture.height;
    const auto most = static_cast<float>(8.0 * tolerance / 255.0);
    PixelsLeft left{std::vector<std::uint8_t>(static_cast<std::size_t>(width * height)), 0};
    std::atomic<std::size_t> count = 0;
    const auto pixel = [&](std::ptrdiff_t column, std::ptrdiff_t row) {
        return picture.rgba.data() + (row * width + column) * channels;
    };
    const auto forRows = [&](std::ptrdiff_t first, const auto& visit) {
        const std::ptrdiff_t rows = std::max<std::ptrdiff_t>(0, (box.lastRow - first + apart - 1) / apart);
        parallelFor(LoopRange<std::ptrdiff_t>(0, rows, 16), [&](const auto& range) {
            std::size_t here = 0;
            for (std::ptrdiff_t i = range.begin(); i < range.end(); ++i) here += visit(first + i * apart);
            count += here;
        });
    };
    const std::ptrdiff_t firstColumn = box.firstColumn / apart * apart, firstRow = box.firstRow / apart * apart;
    const auto choose = [&](std::ptrdiff_t column, std::ptrdiff_t row, bool filled) {
        left.chosen[static_cast<std::size_t>(row * width + column)] = filled ? 0 : 1;
        return std::size_t{filled ? 0U : 1U};
    };
    // Rows of rays come first, then those between them, which hold none yet.
    forRows(firstRow, [&](std::ptrdiff_t row) {
        std::size_t chosen = 0;
        for (std::ptrdiff_t column = firstColumn + half; column < box.lastColumn; column += apart) {
            const std::ptrdiff_t before = column - half, behind = column + half;
            const std::ptrdiff_t first = std::max<std::ptrdiff_t>(before - apart, 0),
                                 last = behind + apart < width ? behind + apart : behind;
            const bool filled = behind < width && fillMiddle(pixel(first, row), pixel(before, row), pixel(behind, row),
                                                             pixel(last, row), most, pixel(column, row));
            chosen += choose(column, row, filled);
        }
        return chosen;
    });
    forRows(firstRow + half, [&](std::ptrdiff_t row) {
        std::size_t chosen = 0;
        const std::ptrdiff_t before = row - half, behind = row + half;
        const std::ptrdiff_t first = std::max<std::ptrdiff_t>(before - apart, 0),
                             last = behind + apart < height ? behind + apart : behind;
        for (std::ptrdiff_t column = firstColumn; column < box.lastColumn; column += apart) {
            const bool filled =
                behind < height && fillMiddle(pixel(column, first), pixel(column, before), pixel(column, behind),
                                              pixel(column, last), most, pixel(column, row));
            chosen += choose(column, row, filled);
        }
        return chosen;
    });
    const auto isLeft = [&](std::ptrdiff_t column, std::ptrdiff_t row) {
        return column >= width || row >= height || left.chosen[static_cast<std::size_t>(row * width + column)] != 0;
    };
    forRows(firstRow + half, [&](std::ptrdiff_t row) {
        std::size_t chosen = 0;
        for (std::ptrdiff_t column = firstColumn + half; column < box.lastColumn; column += apart) {
            const bool filled = !isLeft(column, row - half) && !isLeft(column - half, row) &&
                                !isLeft(column, row + half) && !isLeft(column + half, row);
            if (filled)
                for (std::ptrdiff_t i = 0; i < channels; ++i)
                    pixel(column, row)[i] =
                        0.25f * (pixel(column - half, row - half)[i] + pixel(column + half, row - half)[i] +
                                 pixel(column - half, row + half)[i] + pixel(column + half, row + half)[i]);
            chosen += choose(column, row, filled);
        }
        return chosen;
    });
    left.count = count;
    return left;
}

}  // namespace echolucent::ray_casting
