#include "processing/designers/otsu.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "processing/designers/designer_contract.h"
#include "processing/intensity/intensity_counts.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

/// Sums over the intensities before an index: the dark class of a threshold there.
class Splits {
public:
    explicit Splits(const IntensityCounts& counts) : m_counts(counts) {
        for (std::size_t i = 0; i < counts.counts.size(); ++i)
            m_sum += static_cast<double>(counts.counts[i]) * counts.intensities[i];
    }
    /// Moves the next intensity into the dark class and returns the variance between the classes.
    double next() {
        m_darkVoxels += static_cast<double>(m_counts.counts[m_index]);
        m_darkSum += static_cast<double>(m_counts.counts[m_index]) * m_counts.intensities[m_index];
        ++m_index;
        const auto all = static_cast<double>(m_counts.total);
        const double brightVoxels = all - m_darkVoxels;
        const double apart = (m_sum - m_darkSum) / brightVoxels - m_darkSum / m_darkVoxels;
        return m_darkVoxels / all * (brightVoxels / all) * apart * apart;
    }

private:
    const IntensityCounts& m_counts;
    double m_sum = 0.0, m_darkVoxels = 0.0, m_darkSum = 0.0;
    std::size_t m_index = 0;
};

IntensityClass classOf(const IntensityCounts& counts, std::size_t first, std::size_t last) {
    double voxels = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        voxels += static_cast<double>(counts.counts[i]);
        sum += static_cast<double>(counts.counts[i]) * counts.intensities[i];
    }
    const double mean = sum / voxels;
    for (std::size_t i = first; i < last; ++i)
        squares += static_cast<double>(counts.counts[i]) * std::pow(counts.intensities[i] - mean, 2);
    return {voxels / static_cast<double>(counts.total), mean, std::sqrt(squares / voxels)};
}

/// The variance between the classes over the threshold, at 256 thresholds.
DesignPlot betweenVariances(const IntensityCounts& counts) {
    DesignPlot plot{"between_variance", "Variance between the classes", "", {}, {}};
    Splits splits(counts);
    std::size_t dark = 0;
    double variance = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 256; ++i) {
        const double threshold = i / 255.0;
        for (; dark + 1 < counts.counts.size() && counts.intensities[dark] <= threshold; ++dark)
            variance = splits.next();
        const bool both = dark > 0 && counts.intensities.back() > threshold;
        plot.intensities.push_back(threshold);
        plot.values.push_back(both ? variance : std::numeric_limits<double>::quiet_NaN());
    }
    return plot;
}

const ParameterTable<OtsuConfig>& otsuTable() {
    using namespace parameter_rows;
    static const ParameterTable<OtsuConfig> table{{
        number<&OtsuConfig::spreads>(
            {"spreads", "Spreads", "How far the ramp reaches below and above the threshold, each by its own class",
             "standard deviations", "docs/designers/otsu.md"},
            {0, 4}),
        number<&OtsuConfig::opacity>(
            {"opacity", "Opacity", "Opacity of the bright class beyond the ramp", "", "chosen by looking"}, {0, 1}),
    }};
    return table;
}

}  // namespace

std::optional<OtsuClasses> otsuClasses(const IntensityCounts& counts) {
    const std::size_t intensities = counts.counts.size();
    if (intensities < 2) return std::nullopt;
    Splits splits(counts);
    std::size_t best = 0;
    double largest = -1.0;
    for (std::size_t dark = 1; dark < intensities; ++dark) {
        const double variance = splits.next();
        if (!(variance > largest)) continue;
        largest = variance;
        best = dark;
    }
    return OtsuClasses{0.5 * (counts.intensities[best - 1] + counts.intensities[best]), classOf(counts, 0, best),
                       classOf(counts, best, intensities), largest};
}

const ParameterTable<OtsuConfig>& parametersOf(const OtsuConfig&) { return otsuTable(); }

std::optional<Design> design(const OtsuConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("OtsuConfig", parametersOf(config), config, input);
    const IntensityCounts counts = intensityCounts(input.shown);
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    const auto classes = otsuClasses(counts);
    if (!classes) {
        Design design{PowerCurve{2, 1.0}};
        design.message = counts.total == 0 ? "No voxel carries data: x^2 is used."
                                           : "All voxels with data have one intensity, which no threshold splits: x^2 "
                                             "is used.";
        return design;
    }
    const double begin = std::max(0.0, classes->threshold - config.spreads * classes->dark.spread);
    const double end = std::min(1.0, classes->threshold + config.spreads * classes->bright.spread);
    Design design{ManualCurve{{{begin, 0.0}, {end, config.opacity}}}};
    design.explanation = {
        "Otsu's threshold splits the voxels at " + inWords(classes->threshold) + " into a dark class (" +
            percentInWords(classes->dark.share) + " of them, mean " + inWords(classes->dark.mean) + ", spread " +
            inWords(classes->dark.spread) + ") and a bright one (mean " + inWords(classes->bright.mean) + ", spread " +
            inWords(classes->bright.spread) + ").",
        "The curve is clear up to " + inWords(begin) + " and has its full opacity of " + inWords(config.opacity) +
            " from " + inWords(end) + " on: the ramp reaches " + inWords(config.spreads) +
            " times the dark class's spread below the threshold and as many times the bright "
            "class's above it, within 0 and 1."};
    design.facts = {{"threshold", "Threshold", classes->threshold},
                    {"dark_mean", "Mean of the dark class", classes->dark.mean},
                    {"dark_spread", "Spread of the dark class", classes->dark.spread},
                    {"dark_share", "Voxels in the dark class", classes->dark.share, "share"},
                    {"bright_mean", "Mean of the bright class", classes->bright.mean},
                    {"bright_spread", "Spread of the bright class", classes->bright.spread},
                    {"ramp_begin", "Ramp begins at", begin},
                    {"ramp_end", "Ramp ends at", end}};
    design.plots = {betweenVariances(counts)};
    return design;
}

}  // namespace echolucent
