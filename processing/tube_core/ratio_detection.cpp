#include "processing/tube_core/ratio_detection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace echolucent {

namespace {

/// Half of `behind`, rounded up: what must at least lie behind a boundary.
int leastBehind(const RatioRule& rule) { return (rule.behind + 1) / 2; }

void scaleProfile(std::span<const float> means, const SpeckleScale& scale, std::vector<float>& scaled) {
    scaled.resize(means.size());
    scale.scale(means, scaled);
}

double meanOf(std::span<const float> values) {
    double sum = 0.0;
    for (const float value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

std::span<const float> slabs(std::span<const float> profile, int first, int last) {
    const int size = static_cast<int>(profile.size());
    first = std::clamp(first, 0, size);
    last = std::clamp(last, first, size);
    return profile.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
}

/// Counts |contrast| of all tubes, finely enough for a quantile.
class ContrastCounts {
public:
    void add(std::span<const float> contrasts) {
        for (const float contrast : contrasts)
            ++m_bins[static_cast<std::size_t>(std::min(std::abs(contrast) * perContrast, bins - 1.0f))];
        m_count += contrasts.size();
    }
    /// The standard deviation of normal noise with this lower quartile of its absolute values.
    [[nodiscard]] double spread() const {
        constexpr double quartileOfNormal = 0.318639;
        const double quarter = static_cast<double>(m_count) / 4.0;
        double below = 0.0;
        std::size_t bin = 0;
        while (bin + 1 < m_bins.size() && below + m_bins[bin] < quarter) below += m_bins[bin++];
        const double part = m_bins[bin] > 0 ? (quarter - below) / m_bins[bin] : 0.0;
        return (static_cast<double>(bin) + part) / perContrast / quartileOfNormal;
    }

private:
    static constexpr float perContrast = 128.0f;
    static constexpr float bins = 4096.0f;
    std::array<std::uint32_t, 4096> m_bins{};
    std::size_t m_count = 0;
};

}  // namespace

void contrastsAlong(std::span<const float> scaled, const RatioRule& rule, std::vector<float>& contrasts) {
    const int size = static_cast<int>(scaled.size());
    const int first = rule.leastFluid, last = size - leastBehind(rule);
    contrasts.resize(static_cast<std::size_t>(std::max(0, last - first + 1)));
    if (contrasts.empty()) return;
    double before = 0.0, behind = 0.0;
    int beforeFirst = std::max(0, first - rule.before), behindLast = std::min(size, first + rule.behind);
    for (int k = beforeFirst; k < first; ++k) before += scaled[static_cast<std::size_t>(k)];
    for (int k = first; k < behindLast; ++k) behind += scaled[static_cast<std::size_t>(k)];
    double perBefore = 1.0 / (first - beforeFirst), perBehind = 1.0 / (behindLast - first);
    for (int boundary = first; boundary <= last; ++boundary) {
        contrasts[static_cast<std::size_t>(boundary - first)] =
            static_cast<float>(behind * perBehind - before * perBefore);
        if (boundary == last) break;
        // What enters and what leaves is added in one: the sums wait for one addition a boundary, not for two.
        const double passing = scaled[static_cast<std::size_t>(boundary)];
        if (boundary + 1 - beforeFirst > rule.before)
            before += passing - scaled[static_cast<std::size_t>(beforeFirst++)];
        else {
            before += passing;
            perBefore = 1.0 / (boundary + 1 - beforeFirst);
        }
        if (behindLast < size)
            behind += scaled[static_cast<std::size_t>(behindLast++)] - passing;
        else {
            behind -= passing;
            perBehind = 1.0 / (behindLast - boundary - 1);
        }
    }
}

namespace {

/// The boundary of highest contrast on a tube.
struct Strongest {
    int boundary = -1;
    float contrast = 0.0f;
    double middle = 0.0;  ///< halfway between the levels on its two sides, on the scale
};

Strongest strongestAt(std::span<const float> scaled, int boundary, float contrast, const RatioRule& rule) {
    const double before = meanOf(slabs(scaled, boundary - rule.before, boundary));
    return {boundary, contrast, before + contrast / 2.0};
}

/// The value at a share of the way from the least to the largest; values not empty.
double quantileOf(std::vector<double>& values, double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The median middle of the stronger boundaries. Fluid is so much darker than anything else that the boundaries of
/// tissue against brighter tissue are the weaker ones.
double fluidLevel(const std::vector<Strongest>& strongest, double leastContrast) {
    std::vector<double> contrasts, middles;
    for (const Strongest& boundary : strongest)
        if (boundary.contrast > leastContrast) contrasts.push_back(boundary.contrast);
    constexpr double high = 0.9, nearly = 0.6;
    const double least = nearly * quantileOf(contrasts, high);
    for (const Strongest& boundary : strongest)
        if (boundary.contrast >= std::max(least, leastContrast)) middles.push_back(boundary.middle);
    return quantileOf(middles, 0.5);
}

}  // namespace

RatioThresholds ratioThresholds(const TubeProfiles& profiles, const SpeckleScale& scale, const RatioRule& rule) {
    RatioThresholds thresholds;
    std::vector<float> scaled, contrasts;
    std::vector<Strongest> strongest(profiles.tubes());
    ContrastCounts counts;
    std::size_t tubesWithProfile = 0;
    for (std::size_t t = 0; t < profiles.tubes(); ++t) {
        scaleProfile(profiles.means(t), scale, scaled);
        contrastsAlong(scaled, rule, contrasts);
        counts.add(contrasts);
        const auto most = std::max_element(contrasts.begin(), contrasts.end());
        if (!scaled.empty()) ++tubesWithProfile;
        if (most != contrasts.end())
            strongest[t] =
                strongestAt(scaled, static_cast<int>(most - contrasts.begin()) + rule.leastFluid, *most, rule);
    }
    const auto inSpreads = [&, spread = counts.spread()](double times) {
        return std::clamp(times * spread, rule.leastContrast, std::max(rule.leastContrast, rule.sureContrast));
    };
    thresholds.contrast = inSpreads(rule.falseAlarm);
    const auto certain = std::count_if(strongest.begin(), strongest.end(),
                                       [contrast = inSpreads(rule.certainty)](const Strongest& boundary) {
                                           return boundary.boundary >= 0 && boundary.contrast > contrast;
                                       });
    if (certain < 1 || static_cast<double>(certain) < rule.certainShare * static_cast<double>(tubesWithProfile))
        return thresholds;

    thresholds.anyBoundary = true;
    thresholds.fluidLevel = fluidLevel(strongest, thresholds.contrast);
    return thresholds;
}

namespace {

/// Where the running mean of `cellSize` slabs first rises through the half between the levels on both sides of a
/// boundary, nearest to it: the middle of the ramp, in intensity.
int cellAtHalf(std::span<const float> means, int boundary, const RatioRule& rule, int cellSize) {
    const double low = meanOf(slabs(means, boundary - rule.before, boundary - rule.ramp));
    const double high = meanOf(slabs(means, boundary + rule.ramp, boundary + rule.ramp + rule.behind));
    const double half = (low + high) / 2.0;
    const int centred = boundary - cellSize / 2;
    const int lastCell = static_cast<int>(means.size()) - cellSize;
    const auto cellMean = [&](int cell) { return meanOf(slabs(means, cell, cell + cellSize)); };
    int best = std::clamp(centred, 0, lastCell);
    double nearest = std::numeric_limits<double>::infinity();
    for (int cell = std::max(0, boundary - rule.leastFluid); cell < std::min(lastCell, boundary + rule.behind);
         ++cell) {
        const double here = cellMean(cell), next = cellMean(cell + 1);
        if (!(here < half && next >= half)) continue;
        const double distance = std::abs(cell + 0.5 - centred);
        if (distance >= nearest) continue;
        nearest = distance;
        best = half - here < next - half ? cell : cell + 1;
    }
    return best;
}

/// The contrast, a difference of logarithms, is highest on the dark side of a wide ramp: from there the levels on both
/// sides are read anew where the half was found, until it stays.
int surfaceCellAt(std::span<const float> means, int boundary, const RatioRule& rule, int cellSize) {
    int cell = cellAtHalf(means, boundary, rule, cellSize);
    constexpr int mostRounds = 3;
    for (int round = 0; round < mostRounds; ++round) {
        const int next = cellAtHalf(means, cell + cellSize / 2, rule, cellSize);
        if (next == cell) break;
        cell = next;
    }
    return cell;
}

}  // namespace

std::optional<RatioSurface> firstFluidToTissue(std::span<const float> means, const SpeckleScale& scale,
                                               const RatioThresholds& thresholds, const RatioRule& rule, int cellSize) {
    if (!thresholds.anyBoundary || static_cast<int>(means.size()) < cellSize) return std::nullopt;
    std::vector<float> scaled, contrasts;
    scaleProfile(means, scale, scaled);
    contrastsAlong(scaled, rule, contrasts);
    const auto boundaryOf = [&](std::size_t i) { return static_cast<int>(i) + rule.leastFluid; };
    const auto counts = [&](std::size_t i) {
        if (contrasts[i] <= thresholds.contrast) return false;
        const int boundary = boundaryOf(i);
        return meanOf(slabs(scaled, boundary - rule.before, boundary)) < thresholds.fluidLevel;
    };
    const auto reachesTissue = [&](std::size_t i) {
        const int boundary = boundaryOf(i);
        return meanOf(slabs(scaled, boundary, boundary + rule.behind)) > thresholds.fluidLevel;
    };
    std::size_t i = 0;
    while (i < contrasts.size() && !(counts(i) && reachesTissue(i))) ++i;
    if (i == contrasts.size()) return std::nullopt;
    std::size_t highest = i;
    for (; i < contrasts.size() && counts(i); ++i)
        if (contrasts[i] > contrasts[highest]) highest = i;
    return RatioSurface{surfaceCellAt(means, boundaryOf(highest), rule, cellSize), contrasts[highest]};
}

}  // namespace echolucent
