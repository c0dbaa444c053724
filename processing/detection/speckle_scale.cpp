#include "processing/detection/speckle_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "processing/tube_core/slabs/profile_kernels.h"

namespace echolucent {

namespace {

constexpr int meanBins = 64;
constexpr int spreadBins = 128;
/// Bins of spreads grow by one factor, from the least to the largest spread that a slab can have (0.5).
constexpr double leastSpread = 0.001;
constexpr double largestSpread = 0.5;
/// A bin of means counts if it holds at least this share of the slabs of the fullest bin near it. Rarer means belong to
/// slabs with a boundary in them, above all of tube cores that graze a wall. Their spread is not that of speckle.
constexpr double leastShare = 0.25;
constexpr int nearBins = 8;
constexpr std::uint32_t leastSlabs = 16;

/// A spread below this share of the mean is no speckle, and is raised to the share. So spreads stay above 0, and a
/// difference is a ratio even without noise.
constexpr double leastShareOfMean = 0.05;

struct Knot {
    double mean, spread;
};

struct SpreadCounts {
    std::array<std::uint32_t, spreadBins> bins{};
    std::uint32_t count = 0;
    double sumOfMeans = 0.0;

    /// The median, interpolated within its bin.
    [[nodiscard]] double medianSpread() const {
        const double half = count / 2.0, step = std::log(largestSpread / leastSpread) / spreadBins;
        double below = 0.0;
        std::size_t bin = 0;
        while (bin + 1 < bins.size() && below + bins[bin] < half) below += bins[bin++];
        const double part = bins[bin] > 0 ? (half - below) / bins[bin] : 0.0;
        return leastSpread * std::exp(step * (static_cast<double>(bin) + part));
    }
};

std::array<SpreadCounts, meanBins> countSpreads(const TubeProfiles& profiles) {
    std::array<SpreadCounts, meanBins> counts;
    const float perFactor = spreadBins / static_cast<float>(std::log(largestSpread / leastSpread));
    // Neighbouring slabs share their speckle: every second one tells as much.
    constexpr std::size_t stride = 2;
    // Neighbours mostly share a bin. Two sums take turns, so that no addition waits for the one before.
    std::array<std::array<double, meanBins>, 2> sumsOfMeans{};
    for (std::size_t t = 0; t < profiles.tubes(); ++t) {
        const auto means = profiles.means(t), spreads = profiles.spreads(t);
        for (std::size_t k = t % stride; k < means.size(); k += stride) {
            const auto bin =
                static_cast<std::size_t>(std::clamp(static_cast<int>(means[k] * meanBins), 0, meanBins - 1));
            SpreadCounts& slot = counts[bin];
            const float factor =
                std::log(std::max(spreads[k], static_cast<float>(leastSpread)) / static_cast<float>(leastSpread));
            ++slot.bins[static_cast<std::size_t>(std::clamp(static_cast<int>(factor * perFactor), 0, spreadBins - 1))];
            ++slot.count;
            sumsOfMeans[k / stride % 2][bin] += means[k];
        }
    }
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
        counts[bin].sumOfMeans = sumsOfMeans[0][bin] + sumsOfMeans[1][bin];
    return counts;
}

std::vector<Knot> knotsOf(const std::array<SpreadCounts, meanBins>& counts) {
    std::vector<Knot> knots;
    for (int bin = 0; bin < meanBins; ++bin) {
        const SpreadCounts& here = counts[static_cast<std::size_t>(bin)];
        std::uint32_t fullest = 0;
        for (int other = std::max(0, bin - nearBins); other <= std::min(meanBins - 1, bin + nearBins); ++other)
            fullest = std::max(fullest, counts[static_cast<std::size_t>(other)].count);
        if (here.count >= leastSlabs && here.count >= leastShare * fullest)
            knots.push_back({here.sumOfMeans / here.count, here.medianSpread()});
    }
    if (knots.empty()) knots.push_back({0.5, leastSpread});
    // Speckle multiplies and scanners compress, so the spread of speckle never grows faster than the mean. If a spread
    // grows faster, a tube core straddles a wall along its whole length.
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (knots[i - 1].mean > 0.0)
            knots[i].spread = std::min(
                knots[i].spread, knots[i].mean * std::max(knots[i - 1].spread / knots[i - 1].mean, leastShareOfMean));
    return knots;
}

/// The mean of the bin in which the brightest fiftieth of the slabs begins; 0 without slabs.
double brightMeanOf(const std::array<SpreadCounts, meanBins>& counts) {
    std::uint64_t all = 0, above = 0;
    for (const SpreadCounts& bin : counts) all += bin.count;
    for (std::size_t bin = counts.size(); bin-- > 0;) {
        above += counts[bin].count;
        if (above * 50 >= all && counts[bin].count > 0) return counts[bin].sumOfMeans / counts[bin].count;
    }
    return 0.0;
}

/// Linear between the knots and constant above the last. Below the first knot the spread is proportional to the mean,
/// as in echo without an offset, but never less than half of the first knot's spread or than leastSpread: the darkest
/// voxels are rounded.
double spreadFrom(const std::vector<Knot>& knots, double mean) {
    const auto above = std::find_if(knots.begin(), knots.end(), [mean](const Knot& knot) { return knot.mean > mean; });
    if (above == knots.end()) return knots.back().spread;
    if (above == knots.begin())
        return std::max(leastSpread, above->spread * std::max(0.5, above->mean > 0.0 ? mean / above->mean : 1.0));
    const Knot& below = *(above - 1);
    const double part = (mean - below.mean) / (above->mean - below.mean);
    return below.spread + part * (above->spread - below.spread);
}

}  // namespace

SpeckleScale::SpeckleScale(const TubeProfiles& profiles) {
    const auto counts = countSpreads(profiles);
    m_brightMean = brightMeanOf(counts);
    const std::vector<Knot> knots = knotsOf(counts);
    constexpr double step = 1.0 / (sampleCount - 1);
    for (std::size_t i = 0; i < m_spread.size(); ++i) {
        const double mean = static_cast<double>(i) * step;
        m_spread[i] = std::max(spreadFrom(knots, mean), leastShareOfMean * mean);
    }
    for (std::size_t i = 1; i < m_scaled.size(); ++i)
        m_scaled[i] = m_scaled[i - 1] + step * (1.0 / m_spread[i - 1] + 1.0 / m_spread[i]) / 2.0;
}

namespace {
template <std::size_t count>
double between(const std::array<double, count>& samples, double intensity) {
    const double position = std::clamp(intensity, 0.0, 1.0) * (count - 1);
    const auto low = std::min(static_cast<std::size_t>(position), count - 2);
    return samples[low] + (position - static_cast<double>(low)) * (samples[low + 1] - samples[low]);
}
}  // namespace

double SpeckleScale::spreadAt(double intensity) const { return between(m_spread, intensity); }

double SpeckleScale::scaled(double intensity) const { return between(m_scaled, intensity); }

void SpeckleScale::scale(std::span<const float> intensities, std::span<float> results) const {
    lookUp(m_scaled, intensities, results);
}

double SpeckleScale::intensityAt(double scaled) const {
    const auto above = std::upper_bound(m_scaled.begin(), m_scaled.end(), scaled);
    if (above == m_scaled.begin()) return 0.0;
    if (above == m_scaled.end()) return 1.0;
    const auto low = static_cast<double>(above - m_scaled.begin() - 1);
    return (low + (scaled - above[-1]) / (above[0] - above[-1])) / (sampleCount - 1);
}

}  // namespace echolucent
