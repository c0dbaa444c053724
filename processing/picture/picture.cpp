#include "processing/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echolucent {

Picture emptyPicture(int width, int height, bool withDepth) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Picture picture{width, height, std::vector<float>(pixels * 4), {}};
    if (withDepth) picture.depthMm.assign(pixels, std::numeric_limits<float>::infinity());
    return picture;
}

void mixIn(Picture& picture, const Picture& other, double share) {
    const auto there = static_cast<float>(share), here = 1.0f - there;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        picture.rgba[i] = here * picture.rgba[i] + there * other.rgba[i];
}

void brighten(Picture& picture, double factor) {
    const auto by = static_cast<float>(factor);
    for (std::size_t pixel = 0; pixel + 4 <= picture.rgba.size(); pixel += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            picture.rgba[pixel + channel] = std::min(by * picture.rgba[pixel + channel], picture.rgba[pixel + 3]);
}

std::vector<std::uint8_t> overBackground(const Picture& picture, const Vec3& background) {
    const std::size_t pixels = picture.rgba.size() / 4;
    std::vector<std::uint8_t> rgb(pixels * 3);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const float* source = &picture.rgba[pixel * 4];
        for (int channel = 0; channel < 3; ++channel) {
            const double behind = background[channel] * (1.0 - static_cast<double>(source[3]));
            const double value = std::clamp(static_cast<double>(source[channel]) + behind, 0.0, 1.0);
            rgb[pixel * 3 + static_cast<std::size_t>(channel)] = static_cast<std::uint8_t>(std::lround(value * 255.0));
        }
    }
    return rgb;
}

}  // namespace echolucent
