// The config of the ramp between two percentiles (docs/designers/percentile.md).
#pragma once

#include "processing/designers/designer_words.h"

namespace echolucent {

/// The ranges stand in parametersOf().
struct PercentileConfig {
    static constexpr DesignerWords words{"percentile", "Percentile ramp"};
    double clear = 60.0;   ///< opacity is 0 up to this percentile of the voxels with data, %
    double full = 95.0;    ///< opacity is full from this one on, %; if not above `clear`, the ramp is a step
    double opacity = 1.0;  ///< full opacity, per unit
    friend bool operator==(const PercentileConfig&, const PercentileConfig&) = default;
};

}  // namespace echolucent
