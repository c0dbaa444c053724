// Where a picture stands: at the surface, before it, behind it, or nowhere.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "processing/comparison/line_samples.h"

namespace echolucent {

/// A ray's shown depth: the depth at which half of the light is held back (sampleAtHalf()). The result counts samples
/// behind the first sample, from -1 on; it is empty if the whole ray holds back less than half of the light.
[[nodiscard]] std::optional<double> shownSample(const RaySamples& ray, const OpacityTable& table);

/// What a picture does with a surface that is known.
enum class ShownSurface : std::uint8_t {
    right,  ///< the shown depth lies at most rightUnits from the surface
    early,  ///< before that: haze, or a wall, hides the surface
    late,   ///< behind that: the surface is washed through
    never,  ///< the whole ray holds back less than half of the light: it shows little or nothing
};
inline constexpr std::array allShownSurfaces{ShownSurface::right, ShownSurface::early, ShownSurface::late,
                                             ShownSurface::never};
/// How far from the surface a shown depth is still right, units. The eye does not see less, and the surfaces of tube
/// cores are not surer.
inline constexpr double rightUnits = 2.0;
/// `unitsBehindSurface` is the shown depth less that of the surface; empty if there is no shown depth.
[[nodiscard]] ShownSurface shownSurfaceAt(std::optional<double> unitsBehindSurface);

/// How many rays' surfaces a picture shows right, and how many it does not.
struct ShownDepth {
    int right = 0, early = 0, late = 0, never = 0;
    [[nodiscard]] int rays() const { return right + early + late + never; }
    /// The share of the rays, [0,1]; empty without rays.
    [[nodiscard]] std::optional<double> share(ShownSurface shown) const;
    void count(ShownSurface shown);
    ShownDepth& operator+=(const ShownDepth& other);
    friend bool operator==(const ShownDepth&, const ShownDepth&) = default;
};

}  // namespace echolucent
