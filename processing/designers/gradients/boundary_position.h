// The position of voxels within boundaries, from the means of a histogram volume (Kindlmann and Durkin 1998, sections 4
// and 5).
#pragma once

#include <optional>
#include <vector>

#include "processing/designers/gradients/histogram_volume.h"

namespace echolucent {

/// Means over the voxels of an intensity, at the intensities i / (HistogramVolume::intensityNodes - 1). NaN if not
/// known.
struct MeanDerivatives {
    std::vector<double> gradient;  ///< g(v), normalised intensity per unit
    std::vector<double> second;    ///< h(v), normalised intensity per square unit
};

/// The means, smoothed over the intensity by a Gaussian of standard deviation `smoothing`, levels of 255, 0 and above;
/// 0 does not smooth. A node of n voxels weighs n / (n + 30), so that many voxels of no boundary do not outweigh the
/// few of a boundary beside them. A mean stands at the mean intensity of its voxels. Means of fewer than 16 voxels,
/// counted with the Gaussian's weights, are not known. Nodes between known means are linear between them. Nodes more
/// than half a level beyond all known means are not known.
[[nodiscard]] MeanDerivatives meanDerivatives(const HistogramVolume& histogram, double smoothing);

/// How wide the volume's boundaries are.
struct BoundaryWidth {
    double smoothed = 0.0;  ///< sigma of the boundaries under the prefilter, units
    double sigma = 0.0;     ///< without it, units; 0 if the prefilter hides it
    double largestGradient = 0.0;
    double largestSecond = 0.0, leastSecond = 0.0;
    double prefilter = 0.0;  ///< units

    /// Whether `smoothed` is sharper than any boundary can be under the prefilter. Then speckle or layers thinner than
    /// the prefilter made what was found. Under a prefilter of one unit or more, even steps between neighbouring voxels
    /// have a `smoothed` of at least 0.86 of the prefilter (measured; docs/designers/kindlmann.md, "Speckle"). Under a
    /// smaller prefilter the answer is always no.
    [[nodiscard]] bool isSharperThanBoundaries() const { return prefilter >= 1.0 && smoothed < 0.85 * prefilter; }
};

/// A boundary of standard deviation sigma has its largest g in the middle and its extreme h at -sigma and sigma. The
/// largest g over the largest h is sigma sqrt(e), so sigma = 2 max g / (sqrt(e) (max h - min h)). A Gaussian prefilter
/// adds its variance to the boundary's; this variance is taken off again. Extremes of h count only if g there is at
/// least 0.3 of the largest g; at those of a boundary it is 0.61. Empty if g is nowhere above 1e-4, or if sigma under
/// the prefilter would exceed `widest`, units.
[[nodiscard]] std::optional<BoundaryWidth> boundaryWidth(const MeanDerivatives& means, double prefilter, double widest);

/// The position of an intensity within boundaries, in standard deviations sigma of the boundary, negative on the darker
/// side: p(v) / sigma = -sigma h(v) / (g(v) - g0). Sigma and derivatives are those under the prefilter. With and
/// without the prefilter, an intensity of an ideal boundary lies at the same multiple of the sigma there. `threshold`
/// is g0 over the largest g, [0,1). NaN if means are not known or g(v) does not exceed g0.
[[nodiscard]] std::vector<double> boundaryPositions(const MeanDerivatives& means, const BoundaryWidth& width,
                                                    double threshold);

/// The same over intensity and gradient magnitude as pictures read them, at the nodes of HistogramVolume::overBoth:
/// p(v, g) / sigma = -smoothed^2 h(v, g) / (g(v, g) - g0) / sigma. A Gaussian smooths by 1.5 nodes along the intensity
/// and half as many along the gradient magnitude. If this Gaussian finds fewer than four voxels, one twice as wide is
/// tried, then one four times as wide. NaN if none finds enough or the mean gradient does not exceed g0. sigma counts
/// as at least half of `smoothed`.
[[nodiscard]] std::vector<double> boundaryPositions(const HistogramVolume& histogram, const BoundaryWidth& width,
                                                    double threshold);

}  // namespace echolucent
