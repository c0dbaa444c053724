// How far a picture is from the reference, and where that is asked.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/benchmarks/plain_reference.h"

namespace echolucent::bench {

namespace {

/// Half the width of the rim: pixels of this picture, and of one of 512.
constexpr double rimPixels = 2.0;

/// Whether the line of a pixel (its place in pixels, fractions allowed) meets the settings' box.
bool meetsBox(const RayCastSettings& settings, double column, double row) {
    const Camera& camera = settings.camera;
    const double pixelMm = camera.heightMm / settings.height;
    const Vec3 point = camera.focalPoint + camera.frame.right * ((column + 0.5 - settings.width * 0.5) * pixelMm) +
                       camera.frame.down * ((row + 0.5 - settings.height * 0.5) * pixelMm);
    double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
    for (int axis = 0; axis < 3; ++axis) {
        const double direction = camera.frame.forward[axis];
        if (direction == 0.0) {
            if (point[axis] < settings.box->low[axis] || point[axis] > settings.box->high[axis]) return false;
            continue;
        }
        const double a = (settings.box->low[axis] - point[axis]) / direction;
        const double b = (settings.box->high[axis] - point[axis]) / direction;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter < leave;
}

/// The box's outline is convex: a pixel is inside and clear of its rim where the corners of a square around it are
/// inside.
bool wellInside(const RayCastSettings& settings, int column, int row) {
    const double rim = rimPixels * std::max(1.0, settings.width / 512.0);
    for (const double x : {-rim, rim})
        for (const double y : {-rim, rim})
            if (!meetsBox(settings, column + x, row + y)) return false;
    return true;
}

/// Sums of squares and the largest, in levels.
struct Differences {
    double squares = 0.0, largest = 0.0;
    std::int64_t count = 0;
    void add(double levels) {
        squares += levels * levels;
        largest = levels <= largest ? largest : levels;  // a NaN counts as largest
        ++count;
    }
    [[nodiscard]] double rmse() const { return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count)); }
};

/// expected(column, row, channel) of the pixels that the stride takes.
template <typename Expected>
PictureError differencesTo(const Expected& expected, const std::vector<float>& rgb, int stride,
                           const RayCastSettings& settings) {
    Differences inside, whole;
    for (int row = 0; row < settings.height; row += stride)
        for (int column = 0; column < settings.width; column += stride) {
            const bool counts = wellInside(settings, column, row);
            for (int channel = 0; channel < 3; ++channel) {
                const auto at = static_cast<std::size_t>((row * settings.width + column) * 3 + channel);
                const double levels = 255.0 * std::abs(static_cast<double>(rgb[at]) - expected(column, row, channel));
                whole.add(levels);
                if (counts) inside.add(levels);
            }
        }
    return {inside.rmse(), inside.largest, whole.rmse(), whole.largest};
}

}  // namespace

PictureError errorOf(const std::vector<float>& rgb, const ReferencePicture& reference,
                     const RayCastSettings& settings) {
    const int stride = reference.stride, kept = (settings.width + stride - 1) / stride;
    const auto expected = [&](int column, int row, int channel) {
        const int place = (row / stride * kept + column / stride) * 3 + channel;
        return static_cast<double>(reference.rgb[static_cast<std::size_t>(place)]);
    };
    return differencesTo(expected, rgb, stride, settings);
}

PictureError differenceOf(const std::vector<float>& rgb, const std::vector<float>& other, int stride,
                          const RayCastSettings& settings) {
    const auto expected = [&](int column, int row, int channel) {
        return static_cast<double>(other[static_cast<std::size_t>((row * settings.width + column) * 3 + channel)]);
    };
    return differencesTo(expected, rgb, stride, settings);
}

std::vector<float> rgbOf(const Picture& picture) {
    std::vector<float> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t pixel = 0; pixel < picture.rgba.size() / 4; ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel) rgb.push_back(picture.rgba[pixel * 4 + channel]);
    return rgb;
}

std::vector<float> enlarged(const Picture& picture, int size) {
    const std::vector<float> small = rgbOf(picture);
    std::vector<float> rgb(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 3);
    /// Place in the small picture of a pixel of the large one: the one before, the one behind, and how far between.
    struct Between {
        int low, high;
        float share;
    };
    const auto between = [&](int pixel, int pixels) {
        const double place = std::clamp((pixel + 0.5) * pixels / size - 0.5, 0.0, pixels - 1.0);
        const int low = static_cast<int>(place);
        return Between{low, std::min(low + 1, pixels - 1), static_cast<float>(place - low)};
    };
    const auto at = [&](int column, int row, int channel) {
        return small[static_cast<std::size_t>((row * picture.width + column) * 3 + channel)];
    };
    for (int row = 0; row < size; ++row) {
        const Between y = between(row, picture.height);
        for (int column = 0; column < size; ++column) {
            const Between x = between(column, picture.width);
            for (int channel = 0; channel < 3; ++channel) {
                const float above = at(x.low, y.low, channel) * (1 - x.share) + at(x.high, y.low, channel) * x.share;
                const float below = at(x.low, y.high, channel) * (1 - x.share) + at(x.high, y.high, channel) * x.share;
                rgb[static_cast<std::size_t>((row * size + column) * 3 + channel)] =
                    above * (1 - y.share) + below * y.share;
            }
        }
    }
    return rgb;
}

}  // namespace echolucent::bench
