#include "processing/tube_core/tube_quality.h"

#include <algorithm>
#include <vector>

namespace echolucent {

bool describeSurface(const CellStatistics& cells, int surfaceCell, int cellSize, int slopeHalfStep, TubeCore& tube) {
    const auto meanOf = [&](int cell) { return cells.means[static_cast<std::size_t>(cell)]; };
    double sum = 0.0, largest = 0.0;
    int count = 0;
    for (int i = cells.firstCell; i <= surfaceCell - cellSize; ++i) {
        if (cells.complete[static_cast<std::size_t>(i)] == 0) continue;
        sum += meanOf(i);
        largest = std::max(largest, meanOf(i));
        ++count;
    }
    if (count == 0) return false;
    const int before = std::max(surfaceCell - slopeHalfStep, cells.firstCell);
    const int behind = std::min(surfaceCell + slopeHalfStep, cells.lastCell);
    tube.surfaceCell = surfaceCell;
    tube.lowIntensity = sum / count;
    tube.lowIntensityMax = largest;
    tube.highIntensity = meanOf(surfaceCell);
    tube.slope = behind > before ? (meanOf(behind) - meanOf(before)) / (behind - before) : 0.0;
    return true;
}

namespace {

/// How many of the ascending values are at most this one.
double rankOf(double value, const std::vector<double>& ascending) {
    return static_cast<double>(std::upper_bound(ascending.begin(), ascending.end(), value) - ascending.begin());
}

}  // namespace

void weighTubes(std::span<TubeCore> tubes, int tubesMeetingVolume, double dMax) {
    std::vector<double> lowMaxima, slopes;
    for (const TubeCore& tube : tubes) {
        if (tube.status != TubeStatus::surface) continue;
        lowMaxima.push_back(*tube.lowIntensityMax);
        if (*tube.slope > 0.0) slopes.push_back(*tube.slope);
    }
    std::sort(lowMaxima.begin(), lowMaxima.end());
    std::sort(slopes.begin(), slopes.end());
    for (TubeCore& tube : tubes) {
        if (tube.status != TubeStatus::surface) continue;
        tube.intensityWeight = 1.0 - rankOf(*tube.lowIntensityMax, lowMaxima) / tubesMeetingVolume;
        tube.slopeWeight = *tube.slope > 0.0 ? rankOf(*tube.slope, slopes) / tubesMeetingVolume : 0.0;
        tube.extraWeight = *tube.highIntensity > *tube.lowIntensity ? 1.0 : 0.0;
        tube.d = dMax * tube.intensityWeight * tube.slopeWeight * tube.extraWeight;
    }
}

}  // namespace echolucent
