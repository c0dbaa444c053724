// Where voxels lie within boundaries, from the means of a histogram volume (Kindlmann and Durkin 1998, sections 4 and
// 5).
#pragma once

#include <optional>
#include <vector>

#include "processing/designers/gradients/histogram_volume.h"

namespace echolucent {

/// Means over the voxels of an intensity, at the intensities i / (HistogramVolume::intensityNodes - 1); NaN where they
/// are not known.
struct MeanDerivatives {
    std::vector<double> gradient;  ///< g(v), normalised intensity per unit
    std::vector<double> second;    ///< h(v), normalised intensity per square unit
};

/// Smoothed by a Gaussian over the intensity of standard deviation `smoothing`, levels of 255, 0 and above; where it is
/// 0, each node stands for itself. A node of n voxels weighs n / (n + 30), so that many voxels of no boundary do not
/// outweigh the few of a boundary beside them. A mean stands at the mean intensity of what it is made of. Means of
/// fewer than 16 voxels are not known. Between means that are known the others are linear; more than half a level
/// beyond them nothing is known.
[[nodiscard]] MeanDerivatives meanDerivatives(const HistogramVolume& histogram, double smoothing);

/// How wide the volume's boundaries are.
struct BoundaryWidth {
    double smoothed = 0.0;  ///< sigma of the boundaries under the prefilter, units
    double sigma = 0.0;     ///< without it, units; 0 where the prefilter hides it
    double largestGradient = 0.0;
    double largestSecond = 0.0, leastSecond = 0.0;
    double prefilter = 0.0;  ///< units

    /// Whether no boundary can be so sharp under the prefilter, so that speckle or layers thinner than the prefilter
    /// made it: under a prefilter of one unit or more even steps between neighbouring voxels have a `smoothed` of 0.86
    /// of it and above (measured; docs/designers/kindlmann.md, "Speckle").
    [[nodiscard]] bool isSharperThanBoundaries() const { return prefilter >= 1.0 && smoothed < 0.85 * prefilter; }
};

/// A boundary of standard deviation sigma has its largest g in the middle and its extreme h at -sigma and sigma, and
/// g / h there are sigma sqrt(e): sigma = 2 max g / (sqrt(e) (max h - min h)). A Gaussian prefilter adds its variance
/// to the boundary's, which is taken off again. Extremes of h count where g is at least 0.3 of its largest: those of a
/// boundary stand at 0.61. Nothing where g is nowhere above 1e-4, or where sigma would exceed `widest`, units.
[[nodiscard]] std::optional<BoundaryWidth> boundaryWidth(const MeanDerivatives& means, double prefilter, double widest);

/// The position of an intensity within boundaries, in standard deviations sigma of the boundary, negative on the darker
/// side: p(v) / sigma = -sigma h(v) / (g(v) - g0), sigma and derivatives being those under the prefilter. `threshold`
/// is g0 over the largest g, [0,1). NaN where means are not known, or where g(v) does not exceed g0. Under the
/// prefilter and without it an intensity of an ideal boundary lies at the same multiple of the sigma there.
[[nodiscard]] std::vector<double> boundaryPositions(const MeanDerivatives& means, const BoundaryWidth& width,
                                                    double threshold);

/// The same over intensity and gradient magnitude as pictures read them, at the nodes of HistogramVolume::overBoth:
/// p(v, g) / sigma = -smoothed^2 h(v, g) / (g(v, g) - g0) / sigma. Nodes are smoothed by a Gaussian of 1.5 nodes along
/// the intensity and half as many along the gradient magnitude; where that finds less than four voxels, of twice and of
/// four times as many. NaN where nothing is found, and where the mean gradient does not exceed g0. sigma counts as half
/// of `smoothed` at least.
[[nodiscard]] std::vector<double> boundaryPositions(const HistogramVolume& histogram, const BoundaryWidth& width,
                                                    double threshold);

}  // namespace echolucent
