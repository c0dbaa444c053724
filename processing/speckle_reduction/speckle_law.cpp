#include "processing/speckle_reduction/speckle_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "processing/speckle_reduction/filter_spacing.h"

namespace echolucent {

namespace {

constexpr int intensityBins = 64;
constexpr double apart = 3.0;  // mean voxels
constexpr std::int64_t mostPairs = 200'000;
/// Rarer intensities are those of boundaries, whose differences are not speckle.
constexpr double leastShare = 0.002;
constexpr std::size_t leastPairs = 32;
constexpr double leastSpread = 0.25 / 255.0;

using Differences = std::array<std::vector<double>, intensityBins>;

/// Adds the differences of every `stride`-th voxel and the one that many places behind it along an axis.
void addPairs(const Volume& volume, int axis, std::int64_t places, std::int64_t stride, Differences& differences) {
    const VolumeGeometry& geometry = volume.geometry();
    const auto a = static_cast<std::size_t>(axis);
    const std::array<std::int64_t, 3> strides{1, geometry.size[0], geometry.size[0] * geometry.size[1]};
    for (std::int64_t first = axis; first < geometry.voxelCount(); first += stride) {
        const std::int64_t second = first + places * strides[a];
        if (first / strides[a] % geometry.size[a] + places >= geometry.size[a]) continue;
        if (!volume.hasData(first) || !volume.hasData(second)) continue;
        const double one = volume.normalisedIntensity(first), other = volume.normalisedIntensity(second);
        const int bin = std::min(intensityBins - 1, static_cast<int>((one + other) / 2.0 * intensityBins));
        differences[static_cast<std::size_t>(bin)].push_back(std::abs(one - other));
    }
}

/// The standard deviation that has this median of |a - b| in normal noise.
double spreadOf(std::vector<double>& differences) {
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return std::max(leastSpread, *middle / 0.9539);
}

/// The line through the bins in logarithms, each counting as much as it has pairs.
SpeckleLaw fitted(Differences& differences) {
    std::size_t pairs = 0;
    for (const auto& bin : differences) pairs += bin.size();
    double weights = 0, x1 = 0, y1 = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        auto& bin = differences[i];
        if (bin.size() < leastPairs || static_cast<double>(bin.size()) < leastShare * static_cast<double>(pairs))
            continue;
        const double x = std::log((static_cast<double>(i) + 0.5) / intensityBins + SpeckleLaw::offset);
        const double y = std::log(spreadOf(bin)), weight = static_cast<double>(bin.size());
        weights += weight;
        x1 += weight * x;
        y1 += weight * y;
        xx += weight * x * x;
        xy += weight * x * y;
    }
    if (weights == 0.0) return {};
    const double varying = xx - x1 * x1 / weights;
    const double slope = varying > 1e-9 * weights ? (xy - x1 * y1 / weights) / varying : 0.0;
    const double exponent = std::clamp(slope, 0.0, 1.0);
    return {std::exp((y1 - exponent * x1) / weights), exponent};
}

}  // namespace

double SpeckleLaw::spreadAt(double intensity) const { return factor * std::pow(intensity + offset, exponent); }

double SpeckleLaw::scaled(double intensity) const {
    const double lifted = intensity + offset;
    constexpr double nearlyOne = 1.0 - 1e-6;
    if (exponent > nearlyOne) return std::log(lifted) / factor;
    return std::pow(lifted, 1.0 - exponent) / (factor * (1.0 - exponent));
}

SpeckleLaw speckleLawOf(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    const Vec3 spacing = filterSpacing(geometry);
    const std::int64_t stride = std::max<std::int64_t>(1, 3 * geometry.voxelCount() / mostPairs);
    Differences differences;
    for (int axis = 0; axis < 3; ++axis) {
        const auto places = std::max<std::int64_t>(1, std::llround(apart / spacing[axis]));
        addPairs(volume, axis, places, stride, differences);
    }
    return fitted(differences);
}

}  // namespace echolucent
