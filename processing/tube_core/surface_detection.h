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

/// The first local maximum within the range that is at least `significance` times the function's largest value there.
/// A plateau counts once, at its middle; the function's first and last sample are never maxima.
[[nodiscard]] std::optional<int> firstSignificantMaximum(std::span<const double> function, IndexRange range,
                                                         double significance);

/// From the valley before `position` to the valley behind it: as far as the function does not rise.
[[nodiscard]] IndexRange valleyToValley(std::span<const double> function, int position);

/// Scratch of trackSurface(), reused between tubes.
struct DetectionScratch {
    std::vector<double> smoothed, padded;
};

/// Where the maximum was at each scale: coarsest first, the unsmoothed function last. Empty: there is no surface, because
/// the coarsest scale has no significant maximum, or the function itself none at all (a constant, a ramp, a step: there
/// the coarse maximum is only the border's). A scale without a maximum in the range keeps position and range.
[[nodiscard]] std::vector<int> trackSurface(std::span<const double> interfaceFunction,
                                            std::span<const GaussianKernel> kernels, double significance,
                                            DetectionScratch& scratch);

}  // namespace echolucent
