// How the tube cores are weighed against each other.
#pragma once

namespace echolucent {

/// The range stands in methodParameters().
struct WeightRule {
    int rankBins = 0;  ///< bins of the histograms of Petersch 2005, eqs. 9 and 10, from 0 to the largest value; if 0,
                       ///< ranks are exact
    friend bool operator==(const WeightRule&, const WeightRule&) = default;
};

}  // namespace echolucent
