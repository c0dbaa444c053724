// What stands around a cast picture: the camera it starts with and the background behind it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "processing/ray_caster.h"

namespace echolucent {

Camera defaultCamera(const VolumeGeometry& geometry, const Viewpoint& view, double aspect) {
    if (!(aspect > 0.0) || !std::isfinite(aspect)) throw std::invalid_argument("defaultCamera: aspect must be above 0");
    constexpr double margin = 1.04;
    Camera camera;
    camera.focalPoint = geometry.centreMm();
    camera.frame = frameOf(view);
    const Vec3 size = geometry.boxMaxMm() - geometry.boxMinMm();
    // The extent of a box along a direction is the sum of its edges' extents.
    const auto extent = [&](const Vec3& direction) {
        return std::abs(direction[0]) * size[0] + std::abs(direction[1]) * size[1] + std::abs(direction[2]) * size[2];
    };
    camera.heightMm = margin * std::max(extent(camera.frame.down), extent(camera.frame.right) / aspect);
    const double halfAngle = camera.viewAngleDegrees * 0.5 * std::numbers::pi / 180.0;
    camera.distanceMm = camera.heightMm * 0.5 / std::tan(halfAngle) + extent(camera.frame.forward) * 0.5;
    return camera;
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
