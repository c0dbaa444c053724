#include "processing/tube_core/tube_quality.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace echolucent {

namespace {

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Means of the complete cells first, first + stride ... up to last.
std::vector<double> completeMeans(const CellStatistics& cells, int first, int last, int stride) {
    std::vector<double> means;
    for (int i = first; i <= last; i += stride)
        if (cells.complete[static_cast<std::size_t>(i)] != 0) means.push_back(cells.means[static_cast<std::size_t>(i)]);
    return means;
}

}  // namespace

std::optional<double> scatterOf(std::span<const double> cellMeans, int apart) {
    const auto step = static_cast<std::size_t>(apart);
    if (cellMeans.size() < 2 * step) return std::nullopt;
    std::vector<double> differences;
    for (std::size_t i = step; i < cellMeans.size(); ++i)
        differences.push_back(std::abs(cellMeans[i] - cellMeans[i - step]));
    // The median of |a - b| is 0.6745 sqrt(2) standard deviations of a in normal noise.
    return medianOf(differences) / 0.9539;
}

bool describeSurface(const CellStatistics& cells, int surfaceCell, const AdaptiveOtfConfig& config, TubeCore& tube) {
    const int stride = config.cellStride;
    const auto meanOf = [&](int cell) { return cells.means[static_cast<std::size_t>(cell)]; };
    const int lastPrior = surfaceCell - (config.priorCellsMayOverlap ? 1 : config.cellSize);
    std::vector<double> prior = completeMeans(cells, cells.firstCell, lastPrior, stride);
    if (prior.empty()) return false;
    double sum = 0.0;
    for (const double mean : prior) sum += mean;
    const int halfStep = std::max(1, (config.slopeHalfStep + stride / 2) / stride) * stride;
    const int before = std::max(surfaceCell - halfStep, cells.firstCell);
    const int behind = std::min(surfaceCell + halfStep, cells.lastCell);
    tube.surfaceCell = surfaceCell;
    tube.lowIntensity = sum / static_cast<double>(prior.size());
    tube.lowIntensityMax = *std::max_element(prior.begin(), prior.end());
    tube.highIntensity = meanOf(surfaceCell);
    tube.slope = behind > before ? (meanOf(behind) - meanOf(before)) / (behind - before) : 0.0;
    if (const auto scatter = scatterOf(prior, (config.cellSize + stride - 1) / stride)) {
        // Without any noise, rounding to stored values would still be some.
        constexpr double leastScatter = 1e-6;
        tube.edgeToNoise = (meanOf(behind) - medianOf(prior)) / std::max(*scatter, leastScatter);
    }
    return true;
}

namespace {

/// How many of the ascending values are at most this one.
double rankOf(double value, const std::vector<double>& ascending) {
    return static_cast<double>(std::upper_bound(ascending.begin(), ascending.end(), value) - ascending.begin());
}

/// The values as the lower ends of their bins, counted in bins; bins of 0: as they are.
void sortIntoBins(std::vector<double>& values, int bins) {
    if (bins == 0 || values.empty()) return;
    const double largest = *std::max_element(values.begin(), values.end());
    if (largest <= 0.0) return;
    for (double& value : values) value = std::min(std::floor(value / largest * bins), bins - 1.0);
}

/// Ranks of values among themselves, in their order, 0 ... 1 after division by total.
std::vector<double> shareOfRanks(std::vector<double> values, int bins, int total) {
    sortIntoBins(values, bins);
    std::vector<double> ascending = values;
    std::sort(ascending.begin(), ascending.end());
    for (double& value : values) value = rankOf(value, ascending) / total;
    return values;
}

}  // namespace

void weighTubes(std::span<TubeCore> tubes, int tubesMeetingVolume, double dMax, double leastEdgeToNoise, int rankBins) {
    std::vector<double> lowMaxima, slopes;
    for (const TubeCore& tube : tubes) {
        if (tube.status != TubeStatus::surface) continue;
        lowMaxima.push_back(*tube.lowIntensityMax);
        if (*tube.slope > 0.0) slopes.push_back(*tube.slope);
    }
    lowMaxima = shareOfRanks(std::move(lowMaxima), rankBins, tubesMeetingVolume);
    slopes = shareOfRanks(std::move(slopes), rankBins, tubesMeetingVolume);
    std::size_t nextLowMaximum = 0, nextSlope = 0;
    for (TubeCore& tube : tubes) {
        if (tube.status != TubeStatus::surface) continue;
        tube.intensityWeight = 1.0 - lowMaxima[nextLowMaximum++];
        tube.slopeWeight = *tube.slope > 0.0 ? slopes[nextSlope++] : 0.0;
        const bool standsOut = leastEdgeToNoise == 0.0 || (tube.edgeToNoise && *tube.edgeToNoise >= leastEdgeToNoise);
        tube.extraWeight = *tube.highIntensity > *tube.lowIntensity && standsOut ? 1.0 : 0.0;
        tube.d = dMax * tube.intensityWeight * tube.slopeWeight * tube.extraWeight;
    }
}

}  // namespace echolucent
