// Where along a ray half of the light is held back.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

namespace echolucent {

/// The depth at which half of the light is held back: the accumulated opacity 1 - prod(1 - alpha_i) of Petersch 2005,
/// eq. 3, reaches one half. Between two samples it is taken to rise along a line; before the first sample it is 0, one
/// sample earlier. `intensities` are a ray's, from front to back; samples without data are NaN and hold nothing back.
/// opacityAt(i, intensity) is the opacity of sample i, [0,1]. The result counts samples behind the first sample, from
/// -1 on; it is empty if the whole ray holds back less than half of the light.
template <typename Intensities, typename OpacityAt>
[[nodiscard]] std::optional<double> sampleAtHalf(const Intensities& intensities, const OpacityAt& opacityAt) {
    constexpr double half = 0.5;
    double transmittance = 1.0;
    for (std::size_t i = 0; i < intensities.size(); ++i) {
        const auto intensity = static_cast<double>(intensities[i]);
        if (std::isnan(intensity)) continue;
        const double before = transmittance;
        transmittance *= 1.0 - opacityAt(i, intensity);
        if (transmittance <= half) return static_cast<double>(i) - 1.0 + (before - half) / (before - transmittance);
    }
    return std::nullopt;
}

}  // namespace echolucent
