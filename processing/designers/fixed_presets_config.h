// The configs of the curves that are the same for every volume (docs/designers/fetal-preset.md, echo-ramp.md).
#pragma once

#include "processing/designers/designer_words.h"

namespace echolucent {

/// 3D Slicer's preset for fetal ultrasound (fetalPresetNodes). It has no parameters.
struct FetalPresetConfig {
    static constexpr DesignerWords words{"fetal-preset", "Fetal preset"};
    friend bool operator==(const FetalPresetConfig&, const FetalPresetConfig&) = default;
};

/// The curve of SlicerHeart's module Echo Volume Render (docs/designers/echo-ramp.md): clear up to the threshold minus
/// the edge, rising to 0.2 at the threshold, 0.8 just above it and 0.95 at the threshold plus the edge.
struct EchoRampConfig {
    static constexpr DesignerWords words{"echo-ramp", "Echo ramp"};
    double threshold = 0.2;  ///< normalised intensity, [0,1]
    double edge = 0.05;      ///< width of the ramp to either side, normalised intensity, [0,1]
    friend bool operator==(const EchoRampConfig&, const EchoRampConfig&) = default;
};

}  // namespace echolucent
