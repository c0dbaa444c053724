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
    std::transform(means.begin(), means.end(), scaled.begin(),
                   [&](float mean) { return static_cast<float>(scale.scaled(mean)); });
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

/// The threshold of two classes that parts a histogram with the largest variance between them (Otsu 1979), as a bin.
template <std::size_t bins>
double otsuBin(const std::array<std::uint64_t, bins>& histogram) {
    double all = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < bins; ++i) {
        all += static_cast<double>(histogram[i]);
        moment += static_cast<double>(histogram[i]) * static_cast<double>(i);
    }
    double weight = 0.0, sum = 0.0, best = -1.0;
    double threshold = 0.0;
    for (std::size_t i = 0; i + 1 < bins; ++i) {
        weight += static_cast<double>(histogram[i]);
        sum += static_cast<double>(histogram[i]) * static_cast<double>(i);
        if (weight == 0.0 || weight == all) continue;
        const double difference = moment * weight / all - sum;
        const double between = difference * difference / (weight * (all - weight));
        if (between > best) {
            best = between;
            threshold = static_cast<double>(i) + 0.5;
        }
    }
    return threshold;
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
    for (int boundary = first; boundary <= last; ++boundary) {
        contrasts[static_cast<std::size_t>(boundary - first)] =
            static_cast<float>(behind / (behindLast - boundary) - before / (boundary - beforeFirst));
        if (boundary == last) break;
        before += scaled[static_cast<std::size_t>(boundary)];
        behind -= scaled[static_cast<std::size_t>(boundary)];
        if (behindLast < size) behind += scaled[static_cast<std::size_t>(behindLast++)];
        if (boundary + 1 - beforeFirst > rule.before) before -= scaled[static_cast<std::size_t>(beforeFirst++)];
    }
}

RatioThresholds ratioThresholds(const TubeProfiles& profiles, const SpeckleScale& scale, const RatioRule& rule) {
    RatioThresholds thresholds;
    std::vector<float> scaled, contrasts;
    struct Strongest {
        int boundary = -1;
        float contrast = 0.0f;
    };
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
            strongest[t] = {static_cast<int>(most - contrasts.begin()) + rule.leastFluid, *most};
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

    constexpr std::size_t levelBins = 256;
    const double top = scale.scaled(1.0);
    std::array<std::uint64_t, levelBins> levels{};
    for (std::size_t t = 0; t < profiles.tubes(); ++t) {
        if (strongest[t].boundary < 0 || strongest[t].contrast < thresholds.contrast) continue;
        thresholds.anyBoundary = true;
        for (const float mean :
             slabs(profiles.means(t), strongest[t].boundary - rule.before, strongest[t].boundary + rule.behind))
            ++levels[std::min(static_cast<std::size_t>(scale.scaled(mean) / top * levelBins), levelBins - 1)];
    }
    thresholds.fluidLevel = (otsuBin(levels) + 0.5) / levelBins * top;
    return thresholds;
}

namespace {

/// Where the running mean of `cellSize` slabs first rises through the half between the levels on both sides of a
/// boundary, nearest to it: the middle of the ramp, in intensity.
int cellAtHalf(std::span<const float> means, int boundary, const RatioRule& rule, int cellSize) {
    // The slabs next to the boundary lie on the ramp.
    constexpr int ramp = 2;
    const double low = meanOf(slabs(means, boundary - rule.before, boundary - ramp));
    const double high = meanOf(slabs(means, boundary + ramp, boundary + ramp + rule.behind));
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
    return RatioSurface{cellAtHalf(means, boundaryOf(highest), rule, cellSize), contrasts[highest]};
}

}  // namespace echolucent
