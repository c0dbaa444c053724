#include "processing/adaptive/found_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "processing/parallel.h"
#include "processing/sampling/sample_at_half.h"
#include "processing/tube_core/slabs/tube_slabs.h"

namespace echolucent {

namespace {

constexpr std::size_t ramps = 8, opacities = 4;
// Shares of the way from I_L to I_H.
constexpr double usualBegin = 0.25, beginStep = 0.07, widthShare = 0.5;
constexpr double clearSpreads = 2.0;  ///< the middle of the tried begins is not nearer to I_L, in spreads of the fluid
constexpr std::array<float, opacities> triedOpacities{1.0f, 0.7f, 0.5f, 0.35f};
constexpr double evenness = 0.6;  ///< of the weights of the mean: the difference of shownRight() that counts e times
constexpr float rightWithin = 2.0f, lostBefore = 3.0f;  // units from the surface
constexpr float lostBehind = static_cast<float>(missedUnits);

/// `behind`: the shown depth less that of the surface, units.
float rightness(float behind) {
    return behind < 0.0f ? std::clamp((lostBefore + behind) / (lostBefore - rightWithin), 0.0f, 1.0f)
                         : std::clamp((lostBehind - behind) / (lostBehind - rightWithin), 0.0f, 1.0f);
}

/// Ramps of full opacity, each with all of triedOpacities. Their loops have no branch, so that they become vectors.
struct TriedRamps {
    std::array<float, ramps> begin;
    float perIntensity;
};
using Shown = std::array<std::array<float, ramps>, opacities>;

/// How right each ramp shows the profile's surface: as shownRight(), for all ramps at once.
Shown rightnessOf(const AxisProfile& profile, const TriedRamps& tried) {
    constexpr float half = 0.5f, least = 1e-30f;  // numbers below `least` would be slow
    Shown comesThrough, depth;
    for (std::size_t o = 0; o < opacities; ++o) {
        comesThrough[o].fill(1.0f);
        depth[o].fill(std::numeric_limits<float>::infinity());
    }
    for (std::size_t i = 0; i < profile.intensities.size(); ++i) {
        const float intensity = profile.intensities[i];
        if (!(intensity > tried.begin.front())) continue;
        std::array<float, ramps> risen;
        for (std::size_t r = 0; r < ramps; ++r) {
            const float share = (intensity - tried.begin[r]) * tried.perIntensity;
            const float positive = share > 0.0f ? share : 0.0f;
            risen[r] = positive < 1.0f ? positive : 1.0f;
        }
        const float before = static_cast<float>(i) - 1.0f;
        for (std::size_t o = 0; o < opacities; ++o) {
            for (std::size_t r = 0; r < ramps; ++r) {
                const float came = comesThrough[o][r];
                const float held = came * (1.0f - triedOpacities[o] * risen[r]);
                const float comes = held > least ? held : least;
                const float at = before + (came - half) / (came - comes);
                const bool crosses = (came > half) & (comes <= half);
                depth[o][r] = crosses ? at : depth[o][r];
                comesThrough[o][r] = comes;
            }
        }
    }
    Shown right;
    for (std::size_t o = 0; o < opacities; ++o)
        for (std::size_t r = 0; r < ramps; ++r)
            right[o][r] = rightness(depth[o][r] - static_cast<float>(profile.surface));
    return right;
}

constexpr float noData = std::numeric_limits<float>::quiet_NaN();

std::vector<float> intensitiesOf(const SlabMeans& means, const Volume& volume) {
    const auto perValue = static_cast<float>(1.0 / (volume.whiteLevel() * slabScale(volume)));
    std::vector<float> intensities(means.means.size(), noData);
    for (std::size_t k = 0; k < intensities.size(); ++k)
        if (means.counts[k] > 0.0f) intensities[k] = std::min(1.0f, means.means[k] * perValue);
    return intensities;
}

std::vector<float> intensitiesOf(const std::vector<SlabMoments>& moments) {
    std::vector<float> intensities(moments.size(), noData);
    for (std::size_t k = 0; k < intensities.size(); ++k)
        if (moments[k].count > 0) intensities[k] = static_cast<float>(moments[k].mean);
    return intensities;
}

}  // namespace

double opacityAt(const FoundRamp& ramp, double intensity) {
    return ramp.opacity * std::clamp((intensity - ramp.begin) / (ramp.end - ramp.begin), 0.0, 1.0);
}

std::vector<AxisProfile> axisProfiles(const Volume& shown, std::span<const TubeSamples> samples,
                                      std::span<const TubeCore> tubes, const CellRule& rule, const Progress& progress) {
    std::vector<AxisProfile> profiles;
    std::vector<TubeSamples> axes;
    for (std::size_t t = 0; t < tubes.size(); ++t) {
        if (!(tubes[t].d > 0.0)) continue;
        profiles.push_back({{}, tubes[t].surfaceCell + (rule.size - 1) / 2.0});
        // A tube core one sample wide. Its samples may lie between voxels, if the cells are even.
        axes.push_back(samples[t]);
        axes.back().cellSize = 1;
        axes.back().onVoxels = false;
        const int wanted = static_cast<int>(std::ceil(profiles.back().surface + missedUnits)) + 1;
        axes.back().slabs = std::min(axes.back().slabs, wanted);
    }
    const bool fast = rule.precision == Precision::single32 && canMeanSlabs(shown);
    constexpr std::size_t atOnce = 8;
    parallelFor(LoopRange<std::size_t>(0, axes.size(), atOnce), [&](const auto& some) {
        if (progress.cancelled()) return;
        const auto of = std::span(axes).subspan(some.begin(), some.end() - some.begin());
        if (fast) {
            std::vector<SlabMeans> means(of.size());
            meanSlabs(shown, Interpolation::trilinear, of, means);
            for (std::size_t i = 0; i < of.size(); ++i)
                profiles[some.begin() + i].intensities = intensitiesOf(means[i], shown);
            return;
        }
        std::vector<SlabMoments> moments;
        std::vector<double> values;
        for (std::size_t i = 0; i < of.size(); ++i) {
            sampleSlabs(shown, Interpolation::trilinear, of[i], moments, values);
            profiles[some.begin() + i].intensities = intensitiesOf(moments);
        }
    });
    return profiles;
}

double shownRight(std::span<const AxisProfile> profiles, const FoundRamp& ramp) {
    if (profiles.empty()) return 0.0;
    double sum = 0.0;
    for (const AxisProfile& profile : profiles)
        if (const auto shown = sampleAtHalf(profile.intensities,
                                            [&](std::size_t, double intensity) { return opacityAt(ramp, intensity); }))
            sum += rightness(static_cast<float>(*shown - profile.surface));
    return sum / static_cast<double>(profiles.size());
}

std::optional<FoundRamp> rampForEveryWall(std::span<const AxisProfile> profiles, std::span<const TubeCore> tubes) {
    double low = 0.0, high = 0.0, spread = 0.0;
    int count = 0;
    for (const TubeCore& tube : tubes) {
        if (!(tube.d > 0.0)) continue;
        low += *tube.lowIntensity;
        high += *tube.highIntensity;
        spread += tube.fluidSpread.value_or(0.0);
        ++count;
    }
    if (count == 0 || profiles.empty()) return std::nullopt;
    low /= count;
    // A rise that rounding could have made gives a ramp all the same, not a division by 0.
    const double rise = std::max(high / count - low, 1e-6);
    const double width = widthShare * rise;
    const double middle = low + std::max(usualBegin * rise, clearSpreads * spread / count);
    std::array<double, ramps> begin;
    TriedRamps tried;
    for (std::size_t r = 0; r < ramps; ++r) {
        begin[r] = middle + (static_cast<double>(r) - (ramps - 1) / 2.0) * beginStep * rise;
        tried.begin[r] = static_cast<float>(begin[r]);
    }
    tried.perIntensity = static_cast<float>(1.0 / width);

    std::vector<Shown> shown(profiles.size());
    parallelFor(LoopRange<std::size_t>(0, profiles.size(), 8), [&](const auto& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) shown[i] = rightnessOf(profiles[i], tried);
    });
    std::array<std::array<double, ramps>, opacities> right{};
    for (const Shown& one : shown)
        for (std::size_t o = 0; o < opacities; ++o)
            for (std::size_t r = 0; r < ramps; ++r) right[o][r] += static_cast<double>(one[o][r]);

    double sum = 0.0, meanBegin = 0.0, meanLogOpacity = 0.0;
    for (std::size_t o = 0; o < opacities; ++o)
        for (std::size_t r = 0; r < ramps; ++r) {
            const double share = std::exp(right[o][r] / static_cast<double>(profiles.size()) / evenness);
            sum += share;
            meanBegin += share * begin[r];
            meanLogOpacity += share * std::log(static_cast<double>(triedOpacities[o]));
        }
    meanBegin /= sum;
    return FoundRamp{meanBegin, meanBegin + width, std::exp(meanLogOpacity / sum)};
}

}  // namespace echolucent
