#include "processing/designers/percentile.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "processing/designers/designer_contract.h"
#include "processing/intensity/intensity_counts.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

struct Ramp {
    double begin, end;
    std::string message{};
};

/// The counts of the intensities with an index in [first, last).
IntensityCounts countsFrom(const IntensityCounts& counts, std::ptrdiff_t first, std::ptrdiff_t last) {
    IntensityCounts part;
    part.intensities.assign(counts.intensities.begin() + first, counts.intensities.begin() + last);
    part.counts.assign(counts.counts.begin() + first, counts.counts.begin() + last);
    for (const std::uint64_t times : part.counts) part.total += times;
    return part;
}

/// `counts` holds two intensities or more.
Ramp rampOf(const IntensityCounts& counts, const PercentileConfig& config) {
    const double begin = percentileOf(counts, config.clear);
    const double end = percentileOf(counts, std::max(config.clear, config.full));
    if (begin < end || config.full <= config.clear) return {begin, end};
    const auto found = std::ranges::lower_bound(counts.intensities, begin) - counts.intensities.begin();
    const auto last = static_cast<std::ptrdiff_t>(counts.intensities.size());
    const std::string shared =
        "So many voxels have the intensity " + inWords(begin) + " that both percentiles are it: the voxels ";
    if (found + 1 < last)
        return {begin, percentileOf(countsFrom(counts, found + 1, last), config.full),
                shared + "above it alone give the upper end."};
    return {percentileOf(countsFrom(counts, 0, found), config.clear), end,
            shared + "below it alone give the lower end."};
}

/// The share of voxels that do not exceed an intensity, at 256 intensities.
DesignPlot sharesUpTo(const IntensityCounts& counts) {
    DesignPlot plot{"share_up_to", "Voxels up to an intensity", "share", {}, {}};
    std::uint64_t reached = 0;
    std::size_t next = 0;
    for (int i = 0; i < 256; ++i) {
        const double intensity = i / 255.0;
        for (; next < counts.counts.size() && counts.intensities[next] <= intensity; ++next)
            reached += counts.counts[next];
        plot.intensities.push_back(intensity);
        plot.values.push_back(static_cast<double>(reached) / static_cast<double>(counts.total));
    }
    return plot;
}

const ParameterTable<PercentileConfig>& percentileTable() {
    using namespace parameter_rows;
    constexpr std::string_view byLooking = "docs/designers/percentile.md; chosen by looking";
    static const ParameterTable<PercentileConfig> table{{
        number<&PercentileConfig::clear>(
            {"clear", "Clear up to", "Percentile of the voxels up to which opacity is 0", "%", byLooking}, {0, 100}),
        number<&PercentileConfig::full>({"full", "Full from",
                                         "Percentile of the voxels from which opacity is full; a step where it is not "
                                         "above the one up to which opacity is 0",
                                         "%", byLooking},
                                        {0, 100}),
        number<&PercentileConfig::opacity>({"opacity", "Opacity", "Full opacity", "", byLooking}, {0, 1}),
    }};
    return table;
}

}  // namespace

const ParameterTable<PercentileConfig>& parametersOf(const PercentileConfig&) { return percentileTable(); }

std::optional<Design> design(const PercentileConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("PercentileConfig", parametersOf(config), config, input);
    const IntensityCounts counts = intensityCounts(input.shown);
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    if (counts.counts.size() < 2) {
        Design design{PowerCurve{2, 1.0}};
        design.message = counts.total == 0 ? "No voxel carries data: x^2 is used."
                                           : "All voxels with data have one intensity, between which no ramp can "
                                             "stand: x^2 is used.";
        return design;
    }
    Ramp ramp = rampOf(counts, config);
    Design design{ManualCurve{{{ramp.begin, 0.0}, {ramp.end, config.opacity}}}};
    design.explanation = {"The curve is clear up to " + inWords(ramp.begin) + " and has its full opacity of " +
                          inWords(config.opacity) + " from " + inWords(ramp.end) + " on."};
    if (ramp.message.empty() && config.clear < config.full)
        design.explanation.push_back("They are percentile " + inWords(config.clear) + " and percentile " +
                                     inWords(config.full) + " of the voxels with data.");
    else if (ramp.message.empty())
        design.explanation.push_back("Full opacity is asked for from no higher percentile than clear up to, " +
                                     inWords(config.clear) + ", so that the curve is a step there.");
    design.facts = {{"ramp_begin", "Ramp begins at", ramp.begin}, {"ramp_end", "Ramp ends at", ramp.end}};
    design.plots = {sharesUpTo(counts)};
    design.message = std::move(ramp.message);
    return design;
}

}  // namespace echolucent
