// A monotone warp of the intensity axis that carries one distribution of intensities into another
// (docs/designers/template.md).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "processing/designers/template/template_comparison.h"
#include "processing/progress.h"

namespace echolucent {

/// t: an intensity of the reference becomes the intensity of another volume with the same meaning. Both are normalised.
struct IntensityWarp {
    /// t at equidistant intensities of the reference from 0 to 1: two or more, ascending, linear between them. A value
    /// outside [0,1] means that the other volume cuts this intensity off.
    std::vector<double> values{0.0, 1.0};

    /// t(v); v is clamped into [0,1].
    [[nodiscard]] double at(double reference) const;
    /// The intensity of the reference whose t is `other`: 0 below t(0), 1 above t(1).
    [[nodiscard]] double inverse(double other) const;
};

struct WarpRule {
    TemplateComparison comparison = TemplateComparison::logarithm;
    double leastSlope = 0.25;   ///< of t, [1/8,1]
    double largestSlope = 4.0;  ///< of t, [1,8]
};

/// A warp, and how unlike the distributions are before and after it. A distance comes from the weighted squared
/// differences of the comparison, without the price of slopes: it is the root of their mean over the reference's axis.
/// 0 for equal distributions.
struct FoundWarp {
    IntensityWarp warp;
    double distanceBefore = 0.0;
    double distance = 0.0;
};

/// Bins of a histogram of normalised intensities: bin i holds [i/256, (i+1)/256[.
inline constexpr std::size_t warpBins = 256;

/// The warp of the least distance, by dynamic programming over steps of 2 bins of the reference and eighths of a bin of
/// the other (in the way of Rezk-Salama and others 2000). Shares are compared between the ends of a step, so that the
/// comparison includes the warp's own stretching. Everything beyond an end of either axis is compared together, because
/// the first and the last bin hold all that was cut off. A small price on slopes other than 1 decides if no voxel does.
/// Histograms are warpBins shares of voxels, 0 or more, with a sum of 1. Throws std::invalid_argument for other
/// histograms and for slopes out of their range. The result is empty only if progress.cancel was raised. Its bits are
/// the same for any number of threads.
[[nodiscard]] std::optional<FoundWarp> findWarp(std::span<const double> reference, std::span<const double> other,
                                                const WarpRule& rule, const Progress& progress = {});

}  // namespace echolucent
