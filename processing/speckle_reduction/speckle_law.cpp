#include "processing/speckle_reduction/speckle_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "processing/speckle_reduction/filter_spacing.h"

namespace echolucent {

namespace {

constexpr double pairDistance = 3.0;  // mean voxels
constexpr std::int64_t mostPairs = 200'000;
/// Intensities with a smaller share of the pairs belong to boundaries, and their differences are not speckle.
constexpr double leastShare = 0.002;
constexpr std::size_t leastPairs = 32;
constexpr double leastSpread = 0.25 / 255.0;

/// The standard deviation of normal noise in which |a - b| has the median of `differences`; at least leastSpread.
/// Reorders `differences`, which must not be empty.
double spreadOf(std::vector<double>& differences) {
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return std::max(leastSpread, *middle / 0.9539);
}

}  // namespace

double SpeckleLaw::spreadAt(double intensity) const { return factor * std::pow(intensity + offset, exponent); }

double SpeckleLaw::scaled(double intensity) const {
    const double lifted = intensity + offset;
    constexpr double nearlyOne = 1.0 - 1e-6;
    if (exponent > nearlyOne) return std::log(lifted) / factor;
    return std::pow(lifted, 1.0 - exponent) / (factor * (1.0 - exponent));
}

SpeckleLawMeasurement::SpeckleLawMeasurement(VolumeGeometry geometry)
    : m_geometry(std::move(geometry)), m_spacing(filterSpacing(m_geometry)) {}

std::int64_t SpeckleLawMeasurement::placesAlong(int axis) const {
    return std::max<std::int64_t>(1, std::llround(pairDistance / m_spacing[axis]));
}

std::int64_t SpeckleLawMeasurement::reach() const { return placesAlong(2); }

void SpeckleLawMeasurement::add(const Volume& held, const FilterSlab& slab) {
    const auto& size = m_geometry.size;
    const std::array<std::int64_t, 3> steps{1, size[0], size[0] * size[1]};
    const std::int64_t stride = std::max<std::int64_t>(1, 3 * m_geometry.voxelCount() / mostPairs);
    const std::int64_t begin = slab.first * steps[2], end = slab.end * steps[2], heldFrom = slab.firstHeld * steps[2];
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const std::int64_t places = placesAlong(axis);
        // Every stride-th voxel of the whole volume, paired with the one `places` behind it along the axis.
        const std::int64_t passed = begin > axis ? (begin - axis + stride - 1) / stride : 0;
        for (std::int64_t first = axis + passed * stride; first < end; first += stride) {
            if (first / steps[a] % size[a] + places >= size[a]) continue;
            const std::int64_t one = first - heldFrom, other = one + places * steps[a];
            if (!held.hasData(one) || !held.hasData(other)) continue;
            const double here = held.normalisedIntensity(one), there = held.normalisedIntensity(other);
            const int bin = std::min(intensityBins - 1, static_cast<int>((here + there) / 2.0 * intensityBins));
            m_differences[static_cast<std::size_t>(bin)].push_back(std::abs(here - there));
        }
    }
}

/// The line through the bins in logarithms, each bin weighted by its number of pairs.
SpeckleLaw SpeckleLawMeasurement::law() {
    std::size_t pairs = 0;
    for (const auto& bin : m_differences) pairs += bin.size();
    double weights = 0, x1 = 0, y1 = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < m_differences.size(); ++i) {
        auto& bin = m_differences[i];
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

}  // namespace echolucent
