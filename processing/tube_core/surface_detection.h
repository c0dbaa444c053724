// Finding the surface in the interface indicating function by tracking a maximum from coarse to fine (Petersch 2005,
// section 4.1 and Fig. 4; what the paper leaves open as docs/method.md settles it).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/tube_core/scale_space.h"

namespace echolucent {

/// A range of indices, both ends included.
struct IndexRange {
    int first = 0;
    int last = -1;
};

/// From where a share of the largest value is measured.
enum class SignificanceFrom { zero, smallestInRange };

/// The first local maximum within the range that reaches `significance` of the way from zero, or from the function's
/// smallest value there, to its largest value there. A plateau counts once, at its middle; the function's first and last
/// sample are never maxima.
[[nodiscard]] std::optional<int> firstSignificantMaximum(std::span<const double> function, IndexRange range,
                                                         double significance,
                                                         SignificanceFrom from = SignificanceFrom::zero);

/// From the valley before `position` to the valley behind it: as far as the function does not rise.
[[nodiscard]] IndexRange valleyToValley(std::span<const double> function, int position);

/// Scratch of trackSurface(), reused between tubes.
struct DetectionScratch {
    std::vector<double> smoothed, padded;
};

/// Which maximum is tracked.
struct TrackingRule {
    double significance = 0.4;
    /// Between the coarsest scale and the last two steps, significance is measured from the smallest value in the range:
    /// where speckle lifts the whole function, a share of the largest value alone holds nothing back. Not at the coarsest,
    /// where the zero behind the far end would be the smallest value, nor where the surface is only located.
    bool aboveSmallest = true;
};

/// Where the maximum was at each scale: coarsest first, the unsmoothed function last. Empty: there is no surface, because
/// the coarsest scale has no significant maximum, or the function itself none at all (a constant, a ramp, a step: there
/// the coarse maximum is only the border's). A scale without a maximum in the range keeps position and range.
[[nodiscard]] std::vector<int> trackSurface(std::span<const double> interfaceFunction,
                                            std::span<const GaussianKernel> kernels, const TrackingRule& rule,
                                            DetectionScratch& scratch);

}  // namespace echolucent
