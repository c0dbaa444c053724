// Curves that users of 3D Slicer know, as OTF designers. They depend on no voxel (docs/designers/fetal-preset.md and
// docs/designers/echo-ramp.md).
#pragma once

#include <optional>

#include "processing/designers/designer_declarations.h"

namespace echolucent {

/// 3D Slicer's preset for fetal ultrasound (fetalPresetNodes). It has no parameters.
struct FetalPresetConfig {
    static constexpr DesignerWords words{"fetal-preset", "Fetal preset"};
    friend bool operator==(const FetalPresetConfig&, const FetalPresetConfig&) = default;
};
[[nodiscard]] const ParameterTable<FetalPresetConfig>& parametersOf(const FetalPresetConfig&);

/// The same curve for every volume. A fact tells which share of the voxels of input.shown the curve shows. If the curve
/// shows none, the message says so.
[[nodiscard]] std::optional<Design> design(const FetalPresetConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// The curve of SlicerHeart's module Echo Volume Render (docs/designers/echo-ramp.md): clear up to the threshold minus
/// the edge, rising to 0.2 at the threshold, 0.8 just above it and 0.95 at the threshold plus the edge.
struct EchoRampConfig {
    static constexpr DesignerWords words{"echo-ramp", "Echo ramp"};
    double threshold = 0.2;  ///< normalised intensity, [0,1]
    double edge = 0.05;      ///< width of the ramp to either side, normalised intensity, [0,1]
    friend bool operator==(const EchoRampConfig&, const EchoRampConfig&) = default;
};
[[nodiscard]] const ParameterTable<EchoRampConfig>& parametersOf(const EchoRampConfig&);

/// This curve for every volume, cut off at 0 and 1, with the same fact and message.
[[nodiscard]] std::optional<Design> design(const EchoRampConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
