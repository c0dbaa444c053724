// The config of the ramp at Otsu's threshold (docs/designers/otsu.md).
#pragma once

#include "processing/designers/designer_words.h"

namespace echolucent {

/// The ranges stand in parametersOf().
struct OtsuConfig {
    static constexpr DesignerWords words{"otsu", "Otsu ramp"};
    double spreads = 1.0;  ///< the ramp reaches this many class spreads to either side of the threshold
    double opacity = 1.0;  ///< of the bright class beyond the ramp, per unit
    friend bool operator==(const OtsuConfig&, const OtsuConfig&) = default;
};

}  // namespace echolucent
