// What tracking from coarse to fine did at one scale (Petersch 2005, Fig. 4).
#pragma once

#include <optional>
#include <vector>

#include "processing/tube_core/index_range.h"

namespace echolucent {

/// The interface indicating function at one scale that was looked at, and the maximum found.
struct TrackedScale {
    std::optional<double> sigma;   ///< the kernel's standard deviation, units; empty: the unsmoothed function
    std::vector<double> function;  ///< less its floor, and smoothed; from the first cell to the last
    IndexRange searched;      ///< the cells among which a maximum was looked for; empty if tracking had ended before
    std::optional<int> cell;  ///< the cell of the first significant maximum there; empty if there is none
};

}  // namespace echolucent
