// Finds the surface in the interface indicating function by tracking a maximum from coarse to fine (Petersch 2005,
// section 4.1 and Fig. 4; docs/method.md settles what the paper leaves open).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/detection/scale_space.h"
#include "processing/detection/tracked_scale.h"
#include "processing/tube_core/index_range.h"

namespace echolucent {

/// The first local maximum in the range that is at least `significance` times the largest value there. A plateau counts
/// once, at its middle. The function's first and last sample are never maxima.
[[nodiscard]] std::optional<int> firstSignificantMaximum(std::span<const double> function, IndexRange range,
                                                         double significance);

/// From the valley before `position` to the valley behind it: the function does not rise on the way to either.
[[nodiscard]] IndexRange valleyToValley(std::span<const double> function, int position);

/// The function less its floor; values below the floor become 0. The floor is the function's `quantile` (share of
/// values below, [0,1]); 0 takes nothing off. Speckle can lift the whole function, above all in log-compressed data.
/// Without the floor, every maximum then reaches a share of the largest value, and the step down to the zeros behind
/// the far end looks like a peak's fall.
void takeOffFloor(std::span<const double> function, double quantile, std::vector<double>& result);

/// Scratch of trackSurface(), reused between tubes.
struct DetectionScratch {
    std::vector<double> aboveFloor, smoothed;
};

/// The place of the maximum at each scale, as indices into the function: coarsest first, the unsmoothed function last.
/// Tracking begins at the coarsest scale with a significant maximum. The coarsest scale of all may have none: a peak
/// nearer to the front than sigma makes one hill with its mirror image, and short tubes have no room for the kernel. A
/// later scale without a maximum in the range keeps position and range.
///
/// The result is empty if there is no surface: no scale has a maximum, the coarsest has none although
/// coarsestMustHaveMaximum, or the function itself has none (a constant, a ramp, a step). A coarse maximum of such a
/// function comes from the border or from rounding, and the original scale has no place for it.
///
/// If `trace` is given, it gets an entry for each scale that was looked at, coarsest first. The unsmoothed function is
/// always the last one; its range is empty if tracking had ended before.
[[nodiscard]] std::vector<int> trackSurface(std::span<const double> interfaceFunction, ScaleSmoother& smoother,
                                            const VarianceRule& rule, DetectionScratch& scratch,
                                            std::vector<TrackedScale>* trace = nullptr);

}  // namespace echolucent
