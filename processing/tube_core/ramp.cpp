#include "processing/tube_core/ramp.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

void readNeighbourhood(const CellStatistics& cells, const AdaptiveOtfConfig& config, TubeCore& tube) {
    const auto meanOf = [&](int cell) { return cells.means[static_cast<std::size_t>(cell)]; };
    if (config.lowReach > 0) {
        const int last = tube.surfaceCell - config.cellSize;
        const int first = std::max(cells.firstCell, last - config.lowReach + 1);
        double sum = 0.0;
        for (int cell = first; cell <= last; ++cell) sum += meanOf(cell);
        if (last >= first) tube.lowIntensity = sum / (last - first + 1);
    }
    const int reach = std::min(cells.lastCell, tube.surfaceCell + config.highReach);
    for (int cell = tube.surfaceCell; cell <= reach; ++cell)
        tube.highIntensity = std::max(*tube.highIntensity, meanOf(cell));
}

double rampAt(double intensity, const TubeCore& tube, const AdaptiveOtfConfig& config) {
    const double rise = *tube.highIntensity - *tube.lowIntensity;
    const double from = std::max(config.rampBegin * rise, config.clearSpreads * tube.fluidSpread.value_or(0.0));
    const double to = std::max(config.rampEnd * rise, from + leastRampWidth * rise);
    return std::clamp((intensity - *tube.lowIntensity - from) / (to - from), 0.0, 1.0);
}

std::vector<double> meanRamp(std::span<const TubeCore> tubes, const AdaptiveOtfConfig& config, int count) {
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> ramp(size, 0.0);
    double weight = 0.0;
    for (const TubeCore& tube : tubes) {
        if (!(tube.d > 0.0)) continue;
        weight += tube.d;
        for (std::size_t i = 0; i < size; ++i)
            ramp[i] += tube.d * rampAt(static_cast<double>(i) / (count - 1), tube, config);
    }
    if (weight == 0.0) return {};
    for (double& value : ramp) value = std::min(1.0, value / weight);
    return ramp;
}

}  // namespace echolucent
