// Finding the surface in the interface indicating function by tracking a maximum from coarse to fine (Petersch 2005,
// section 4.1 and Fig. 4; what the paper leaves open as docs/method.md settles it).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/detection/scale_space.h"

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

/// What exceeds the function's floor: its quantile (share of values below, [0,1]) is taken off, and what lies below
/// counts 0. Where speckle lifts the whole function (log-compressed data above all), a share of the largest value alone
/// holds nothing back, and the zero behind the far end is a fall. A quantile of 0 takes nothing off.
void takeOffFloor(std::span<const double> function, double quantile, std::vector<double>& result);

/// Scratch of trackSurface(), reused between tubes.
struct DetectionScratch {
    std::vector<double> aboveFloor, smoothed;
};

/// Where the maximum was at each scale, coarsest first, the unsmoothed function last; indices into the function. Unless
/// the coarsest must have one, it begins at the coarsest scale that has a significant maximum: a peak nearer to the
/// front than sigma and its mirror image are one hill at the border, and a short tube has no room for the coarsest
/// kernels. A later scale without a maximum in the range keeps position and range. It is empty where there is no
/// surface, because no scale has a maximum, or the function itself has none (a constant, a ramp, a step: there a coarse
/// maximum is only the border's or rounding's, and the original scale has no place for it).
[[nodiscard]] std::vector<int> trackSurface(std::span<const double> interfaceFunction, ScaleSmoother& smoother,
                                            const VarianceRule& rule, DetectionScratch& scratch);

}  // namespace echolucent
