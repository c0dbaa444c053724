#include "processing/tube_core/ramp.h"

#include <algorithm>
#include <limits>

#include "processing/tube_core/basis_function.h"

namespace echolucent {

namespace {

struct Ramp {
    double from, perIntensity, weight;

    Ramp(const TubeCore& tube, const RampRule& rule) : weight(tube.d) {
        const double rise = *tube.highIntensity - *tube.lowIntensity;
        const double clear = std::max(rule.begin * rise, rule.clearSpreads * tube.fluidSpread.value_or(0.0));
        const double full = std::max(rule.end * rise, clear + leastRampWidth * rise);
        from = *tube.lowIntensity + clear;
        // The width of a tiny rise may become 0, and 0 / 0 is no number.
        perIntensity = 1.0 / std::max(full - clear, std::numeric_limits<double>::min());
    }
    [[nodiscard]] double at(double intensity) const {
        const double share = (intensity - from) * perIntensity;
        const double risen = share > 0.0 ? share : 0.0;
        return risen < 1.0 ? risen : 1.0;
    }
    friend auto operator<=>(const Ramp&, const Ramp&) = default;
};

}  // namespace

RampEnds rampEnds(const TubeCore& tube, const RampRule& rule) {
    const Ramp ramp(tube, rule);
    return {ramp.from, ramp.from + 1.0 / ramp.perIntensity};
}

double rampAt(double intensity, const TubeCore& tube, const RampRule& rule) { return Ramp(tube, rule).at(intensity); }

std::vector<double> meanRamp(std::span<const TubeCore> tubes, const RampRule& rule, int count) {
    std::vector<Ramp> ramps;
    for (const TubeCore& tube : tubes)
        if (tube.d > 0.0) ramps.emplace_back(tube, rule);
    if (ramps.empty()) return {};
    // Sorted, so that the bits do not depend on the order of the tubes.
    std::sort(ramps.begin(), ramps.end());
    const auto size = static_cast<std::size_t>(count);
    CompensatedSum weight;
    std::vector<double> intensities(size), mean(size, 0.0), lost(size, 0.0);
    for (std::size_t i = 0; i < size; ++i) intensities[i] = static_cast<double>(i) / (count - 1);
    for (const Ramp& ramp : ramps) {
        weight.add(ramp.weight);
        for (std::size_t i = 0; i < size; ++i) {
            // Keeps the rounding error (Knuth's two-sum, which has no branch).
            const double term = ramp.weight * ramp.at(intensities[i]), sum = mean[i] + term;
            const double ofTerm = sum - mean[i];
            lost[i] += (mean[i] - (sum - ofTerm)) + (term - ofTerm);
            mean[i] = sum;
        }
    }
    for (std::size_t i = 0; i < size; ++i) mean[i] = std::min(1.0, (mean[i] + lost[i]) / weight.value());
    return mean;
}

}  // namespace echolucent
