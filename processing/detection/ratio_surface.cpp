#include "processing/detection/ratio_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "processing/parallel.h"
#include "processing/tube_core/slabs/profile_kernels.h"

namespace echolucent {

namespace {

/// A task of this many tubes or fewer is not split.
constexpr std::size_t tubesPerTask = 64;

/// Half of slabsBehind, rounded up: at least this many slabs must lie behind a boundary.
int leastBehind(const RatioRule& rule) { return (rule.slabsBehind + 1) / 2; }

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

/// Counts |contrast| of all tubes in bins fine enough for a quantile.
class ContrastCounts {
public:
    void add(std::span<const float> contrasts) {
        for (const float contrast : contrasts)
            ++m_bins[static_cast<std::size_t>(std::min(std::abs(contrast) * perContrast, bins - 1.0f))];
        m_count += contrasts.size();
    }
    /// The standard deviation of normal noise whose absolute values have the counted lower quartile.
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

std::size_t contrastCount(std::size_t slabs, const RatioRule& rule) {
    const int count = static_cast<int>(slabs) - leastBehind(rule) - rule.leastFluid + 1;
    return static_cast<std::size_t>(std::max(0, count));
}

void contrastsAlong(std::span<const float> scaled, const RatioRule& rule, std::span<float> contrasts) {
    const int size = static_cast<int>(scaled.size());
    const int first = rule.leastFluid, last = size - leastBehind(rule);
    if (contrasts.empty()) return;
    // Boundaries with all slabs on both sides go together; the few at the ends go one by one.
    const int firstWhole = std::max(first, rule.slabsBefore), lastWhole = std::min(last, size - rule.slabsBehind);
    const auto at = [first](int boundary) { return static_cast<std::size_t>(boundary - first); };
    if (firstWhole <= lastWhole)
        differencesOfMeans(scaled.subspan(static_cast<std::size_t>(firstWhole - rule.slabsBefore)), rule.slabsBefore,
                           rule.slabsBehind, contrasts.subspan(at(firstWhole), at(lastWhole) - at(firstWhole) + 1));
    for (int boundary = first; boundary <= last; ++boundary) {
        if (boundary == firstWhole && firstWhole <= lastWhole) boundary = lastWhole + 1;
        if (boundary > last) break;
        contrasts[at(boundary)] = static_cast<float>(meanOf(slabs(scaled, boundary, boundary + rule.slabsBehind)) -
                                                     meanOf(slabs(scaled, boundary - rule.slabsBefore, boundary)));
    }
}

namespace {

/// The boundary of highest contrast on a tube; `boundary` is -1 if the tube has none.
struct Strongest {
    int boundary = -1;
    float contrast = 0.0f;
    double middle = 0.0;  ///< halfway between the levels on its two sides, on the scale
};

Strongest strongestAt(std::span<const float> scaled, int boundary, float contrast, const RatioRule& rule) {
    const double before = meanOf(slabs(scaled, boundary - rule.slabsBefore, boundary));
    return {boundary, contrast, before + contrast / 2.0};
}

/// The index of the first of the largest values; `values` is not empty. The loop works in lanes, so that the compiler
/// vectorises it.
std::size_t placeOfLargest(std::span<const float> values) {
    std::array<float, 8> largest;
    largest.fill(values[0]);
    std::size_t i = 0;
    for (; i + largest.size() <= values.size(); i += largest.size())
        for (std::size_t lane = 0; lane < largest.size(); ++lane)
            largest[lane] = values[i + lane] > largest[lane] ? values[i + lane] : largest[lane];
    for (; i < values.size(); ++i) largest[0] = std::max(largest[0], values[i]);
    const float most = *std::max_element(largest.begin(), largest.end());
    return static_cast<std::size_t>(std::find(values.begin(), values.end(), most) - values.begin());
}

/// The value at a share of the way from the least to the largest; values not empty.
double quantileOf(std::vector<double>& values, double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The medians of level and contrast of the stronger boundaries. Fluid is much darker than anything else, so boundaries
/// of tissue against brighter tissue are weaker.
void readLevels(const std::vector<Strongest>& strongest, RatioThresholds& thresholds) {
    std::vector<double> contrasts, middles;
    for (const Strongest& boundary : strongest)
        if (boundary.contrast > thresholds.contrast) contrasts.push_back(boundary.contrast);
    constexpr double high = 0.9, nearly = 0.6;
    const double least = std::max(nearly * quantileOf(contrasts, high), thresholds.contrast);
    contrasts.clear();
    for (const Strongest& boundary : strongest) {
        if (boundary.contrast < least) continue;
        contrasts.push_back(boundary.contrast);
        middles.push_back(boundary.middle);
    }
    const double half = quantileOf(contrasts, 0.5) / 2.0;
    thresholds.fluidLevel = quantileOf(middles, 0.5);
    thresholds.fluid = thresholds.fluidLevel - half;
    thresholds.tissue = thresholds.fluidLevel + half;
}

}  // namespace

TubeContrasts::TubeContrasts(const TubeProfiles& profiles, const SpeckleScale& scale, const RatioRule& rule) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < profiles.tubes(); ++t)
        count += profiles.means(t).size() + contrastCount(profiles.means(t).size(), rule);
    m_values = std::make_unique_for_overwrite<float[]>(count);
    float* next = m_values.get();
    for (std::size_t t = 0; t < profiles.tubes(); ++t) {
        const std::size_t slabCount = profiles.means(t).size(), boundaries = contrastCount(slabCount, rule);
        m_profiles.emplace_back(next, slabCount);
        m_contrasts.emplace_back(next + slabCount, boundaries);
        next += slabCount + boundaries;
    }
    parallelFor(LoopRange<std::size_t>(0, profiles.tubes(), tubesPerTask), [&](const LoopRange<std::size_t>& range) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
            scale.scale(profiles.means(t), m_profiles[t]);
            contrastsAlong(m_profiles[t], rule, m_contrasts[t]);
        }
    });
}

namespace {

/// Whether the boundaries at these levels may be those of fluid.
bool mayBeFluid(const RatioThresholds& thresholds, const SpeckleScale& scale, const RatioRule& rule) {
    const double fluid = scale.intensityAt(thresholds.fluid), tissue = scale.intensityAt(thresholds.tissue);
    if (fluid <= 0.0 || tissue >= rule.leastRatio * fluid) return true;
    // Compressed echo: from a quarter of the bright mean to the bright mean, the mean grows four times, but the spread
    // less than three times.
    constexpr double darker = 0.25, inProportion = 0.75;
    const double bright = scale.brightMean();
    return scale.spreadAt(bright) * darker < inProportion * scale.spreadAt(darker * bright);
}

}  // namespace

RatioThresholds ratioThresholds(const TubeContrasts& tubes, const SpeckleScale& scale, const RatioRule& rule) {
    RatioThresholds thresholds;
    thresholds.step = rule.leastStep * scale.brightMean();
    std::vector<Strongest> strongest(tubes.tubes());
    ContrastCounts counts;
    std::size_t tubesWithProfile = 0;
    for (std::size_t t = 0; t < tubes.tubes(); ++t) {
        const auto scaled = tubes.scaled(t), contrasts = tubes.contrasts(t);
        counts.add(contrasts);
        if (!scaled.empty()) ++tubesWithProfile;
        if (contrasts.empty()) continue;
        const std::size_t most = placeOfLargest(contrasts);
        strongest[t] = strongestAt(scaled, static_cast<int>(most) + rule.leastFluid, contrasts[most], rule);
    }
    const auto inSpreads = [&, spread = counts.spread()](double times) {
        return std::clamp(times * spread, rule.contrastFloor, rule.contrastCeiling);
    };
    thresholds.contrast = inSpreads(rule.falseAlarm);
    const auto certain =
        std::count_if(strongest.begin(), strongest.end(),
                      [contrast = std::max(inSpreads(rule.certainty), thresholds.contrast)](const Strongest& boundary) {
                          return boundary.boundary >= 0 && boundary.contrast > contrast;
                      });
    if (certain < 1 || static_cast<double>(certain) < rule.certainShare * static_cast<double>(tubesWithProfile))
        return thresholds;

    readLevels(strongest, thresholds);
    thresholds.mayHoldSurfaces = mayBeFluid(thresholds, scale, rule);
    return thresholds;
}

namespace {

/// The middle of a boundary's ramp, in intensity. There the running mean of `cellSize` slabs rises through the half
/// between the levels on both sides. Of several such places the one nearest to the boundary counts. If there is none,
/// the cell around the boundary. Returns the cell's first slab.
int cellAtHalf(std::span<const float> means, int boundary, const RatioRule& rule, int cellSize) {
    const double low = meanOf(slabs(means, boundary - rule.slabsBefore, boundary - rule.rampSlabs));
    const double high = meanOf(slabs(means, boundary + rule.rampSlabs, boundary + rule.rampSlabs + rule.slabsBehind));
    const double half = (low + high) / 2.0;
    const int centred = boundary - cellSize / 2;
    const int lastCell = static_cast<int>(means.size()) - cellSize;
    const auto cellMean = [&](int cell) { return meanOf(slabs(means, cell, cell + cellSize)); };
    int best = std::clamp(centred, 0, lastCell);
    double nearest = std::numeric_limits<double>::infinity();
    for (int cell = std::max(0, boundary - rule.leastFluid); cell < std::min(lastCell, boundary + rule.slabsBehind);
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

/// The contrast, a difference of logarithms, is highest on the dark side of a wide ramp. So this function reads the
/// levels again on both sides of the half found, until the cell stays, at most mostRounds times.
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

std::optional<RatioSurface> firstFluidToTissue(std::span<const float> means, std::span<const float> scaled,
                                               std::span<const float> contrasts, const RatioThresholds& thresholds,
                                               const RatioRule& rule, int cellSize) {
    if (!thresholds.mayHoldSurfaces || static_cast<int>(means.size()) < cellSize) return std::nullopt;
    const auto boundaryOf = [&](std::size_t i) { return static_cast<int>(i) + rule.leastFluid; };
    const auto counts = [&](std::size_t i) {
        if (contrasts[i] <= thresholds.contrast) return false;
        const int boundary = boundaryOf(i);
        return meanOf(slabs(scaled, boundary - rule.slabsBefore, boundary)) < thresholds.fluidLevel;
    };
    const auto reachesTissue = [&](std::size_t i) {
        const int boundary = boundaryOf(i);
        if (meanOf(slabs(scaled, boundary, boundary + rule.slabsBehind)) <= thresholds.fluidLevel) return false;
        const double rise = meanOf(slabs(means, boundary, boundary + rule.slabsBehind)) -
                            meanOf(slabs(means, boundary - rule.slabsBefore, boundary));
        return rise >= thresholds.step;
    };
    const auto leavesFluid = [&](std::size_t i) {
        const auto before = slabs(scaled, boundaryOf(i) - rule.slabsBefore, boundaryOf(i));
        return std::count_if(before.begin(), before.end(), [&](float slab) { return slab < thresholds.fluidLevel; }) >=
               rule.leastDark;
    };
    std::size_t i = 0;
    while (i < contrasts.size() && !(counts(i) && leavesFluid(i) && reachesTissue(i))) ++i;
    if (i == contrasts.size()) return std::nullopt;
    std::size_t highest = i;
    for (; i < contrasts.size() && counts(i); ++i)
        if (contrasts[i] > contrasts[highest]) highest = i;
    return RatioSurface{surfaceCellAt(means, boundaryOf(highest), rule, cellSize), contrasts[highest]};
}

}  // namespace echolucent
