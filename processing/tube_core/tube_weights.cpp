#include "processing/tube_core/tube_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace echolucent {

namespace {

/// Replaces each value by the number of its bin; leaves the values as they are if `bins` is 0 or no value is above 0.
void sortIntoBins(std::vector<double>& values, int bins) {
    if (bins == 0 || values.empty()) return;
    const double largest = *std::max_element(values.begin(), values.end());
    if (largest <= 0.0) return;
    for (double& value : values) value = std::min(std::floor(value / largest * bins), bins - 1.0);
}

}  // namespace

std::vector<int> inclusiveRanks(std::vector<double> values, int bins) {
    sortIntoBins(values, bins);
    std::vector<double> ascending = values;
    std::sort(ascending.begin(), ascending.end());
    std::vector<int> ranks(values.size());
    std::transform(values.begin(), values.end(), ranks.begin(), [&](double value) {
        return static_cast<int>(std::upper_bound(ascending.begin(), ascending.end(), value) - ascending.begin());
    });
    return ranks;
}

int tubesMeetingVolume(std::span<const TubeCore> tubes) {
    return static_cast<int>(std::count_if(tubes.begin(), tubes.end(),
                                          [](const TubeCore& tube) { return tube.status != TubeStatus::outside; }));
}

int tubesWithWeight(std::span<const TubeCore> tubes) {
    return static_cast<int>(
        std::count_if(tubes.begin(), tubes.end(), [](const TubeCore& tube) { return tube.d > 0.0; }));
}

void weighTubes(std::span<TubeCore> tubes, double dMax, double leastEdgeToNoise, const WeightRule& rule) {
    const int total = tubesMeetingVolume(tubes);
    std::vector<double> lowMaxima, slopes;
    for (const TubeCore& tube : tubes) {
        if (tube.status != TubeStatus::surface) continue;
        lowMaxima.push_back(*tube.lowIntensityMax);
        if (*tube.slope > 0.0) slopes.push_back(*tube.slope);
    }
    const std::vector<int> ofLowMaxima = inclusiveRanks(std::move(lowMaxima), rule.rankBins);
    const std::vector<int> ofSlopes = inclusiveRanks(std::move(slopes), rule.rankBins);
    const auto share = [total](int rank) { return static_cast<double>(rank) / total; };
    std::size_t nextLowMaximum = 0, nextSlope = 0;
    for (TubeCore& tube : tubes) {
        if (tube.status != TubeStatus::surface) continue;
        tube.intensityWeight = 1.0 - share(ofLowMaxima[nextLowMaximum++]);
        tube.slopeWeight = *tube.slope > 0.0 ? share(ofSlopes[nextSlope++]) : 0.0;
        const bool standsOut = leastEdgeToNoise == 0.0 || (tube.edgeToNoise && *tube.edgeToNoise >= leastEdgeToNoise);
        tube.extraWeight = *tube.highIntensity > *tube.lowIntensity && standsOut ? 1.0 : 0.0;
        tube.d = dMax * tube.intensityWeight * tube.slopeWeight * tube.extraWeight;
    }
}

}  // namespace echolucent
