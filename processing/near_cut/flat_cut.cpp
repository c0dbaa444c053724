#include "processing/near_cut/flat_cut.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

constexpr double nearlyAsMuch = 0.9;      // of the worth of the best depth
constexpr double smoothingSamples = 2.0;  // standard deviation of the smoothing of the worth

/// What stands behind walls: at each depth, and in all.
struct FluidByDepth {
    std::vector<double> weight;  ///< of each depth: sum of contrast times length over the stretches there
    double samples = 0.0, contrast = 0.0;
};

FluidByDepth fluidByDepth(const TubeEcho& tubes, std::span<const std::vector<FluidStretch>> levels) {
    FluidByDepth fluid{std::vector<double>(static_cast<std::size_t>(tubes.samples))};
    for (const auto& stretches : levels)
        for (const FluidStretch& stretch : stretches) {
            if (stretch.atFront) continue;
            fluid.samples += stretch.length();
            fluid.contrast += stretch.contrast * stretch.length();
            for (int sample = stretch.begin; sample < stretch.end; ++sample)
                fluid.weight[static_cast<std::size_t>(sample)] += stretch.contrast * stretch.length();
        }
    return fluid;
}

std::vector<double> worthByDepth(const std::vector<double>& weight) {
    std::vector<double> worth(weight.size());
    double behind = 0.0;
    for (std::size_t i = weight.size(); i-- > 0;) {
        behind += weight[i];
        worth[i] = weight[i] * behind;
    }
    return worth;
}

std::vector<double> smoothed(const std::vector<double>& values) {
    const auto count = static_cast<int>(values.size());
    const int reach = static_cast<int>(2.0 * smoothingSamples);
    std::vector<double> smooth(values.size());
    for (int i = 0; i < count; ++i) {
        double sum = 0.0, weights = 0.0;
        for (int j = std::max(0, i - reach); j <= std::min(count - 1, i + reach); ++j) {
            const double weight = std::exp(-(j - i) * (j - i) / (2.0 * smoothingSamples * smoothingSamples));
            sum += weight * values[static_cast<std::size_t>(j)];
            weights += weight;
        }
        smooth[static_cast<std::size_t>(i)] = sum / weights;
    }
    return smooth;
}

}  // namespace

FlatCut findFlatCut(const TubeEcho& tubes, std::span<const std::vector<FluidStretch>> levels) {
    const FluidByDepth fluid = fluidByDepth(tubes, levels);
    if (fluid.samples == 0.0) return {};
    const std::vector<double> worth = smoothed(worthByDepth(fluid.weight));
    auto cut = std::max_element(worth.begin(), worth.end());
    const double best = *cut;
    while (cut != worth.begin() && *(cut - 1) >= nearlyAsMuch * best) --cut;
    const auto data = static_cast<double>(
        std::count_if(tubes.echo.begin(), tubes.echo.end(), [](float echo) { return echo >= 0.0F; }));
    return {static_cast<int>(cut - worth.begin()), fluid.samples / (data * static_cast<double>(levels.size())),
            fluid.contrast / fluid.samples};
}

}  // namespace echolucent
