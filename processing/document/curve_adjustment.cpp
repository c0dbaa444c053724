#include "processing/document/curve_adjustment.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

constexpr int tableIntensities = 2041;               // the nodes of the ray caster's table
constexpr double leastRise = 0.02, mostRise = 0.98;  // so that neither side of the rise vanishes

/// Where the curve first reaches half of its largest opacity.
double riseOf(const std::vector<double>& opacities) {
    const double half = 0.5 * *std::ranges::max_element(opacities);
    const auto at = std::ranges::find_if(opacities, [half](double opacity) { return opacity >= half; });
    return static_cast<double>(at - opacities.begin()) / static_cast<double>(opacities.size() - 1);
}

}  // namespace

OpacityCurve adjusted(const OpacityCurve& curve, const CurveAdjustment& adjustment) {
    if (adjustment == CurveAdjustment{}) return curve;
    SampledCurve sampled{sampledOpacities(curve, tableIntensities)};
    if (std::ranges::all_of(sampled.opacities, [](double opacity) { return opacity == 0.0; })) return curve;
    const double rise = std::clamp(riseOf(sampled.opacities), leastRise, mostRise);
    const double moved = std::clamp(rise + adjustment.threshold, leastRise, mostRise);
    const double depth = std::pow(4.0, -adjustment.transparency);
    for (int i = 0; i < tableIntensities; ++i) {
        const double intensity = static_cast<double>(i) / (tableIntensities - 1);
        const double before = adjustment.threshold == 0.0 ? intensity
                              : intensity <= moved        ? intensity * rise / moved
                                                          : 1.0 - (1.0 - intensity) * (1.0 - rise) / (1.0 - moved);
        sampled.opacities[static_cast<std::size_t>(i)] = opacityForStep(opacityAt(curve, before), depth);
    }
    return sampled;
}

}  // namespace echolucent
