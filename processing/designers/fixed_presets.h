// Curves that users of 3D Slicer know, as OTF designers: what they show follows from no voxel (docs/designers/
// fetal-preset.md and docs/designers/echo-ramp.md).
#pragma once

#include <optional>
#include <span>

#include "processing/designers/design.h"
#include "processing/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// 3D Slicer's preset for fetal ultrasound (fetalPresetNodes). It has no parameters.
struct FetalPresetConfig {
    friend bool operator==(const FetalPresetConfig&, const FetalPresetConfig&) = default;
};

/// The curve of SlicerHeart's module Echo Volume Render (docs/designers/echo-ramp.md): clear up to the threshold minus
/// the edge, rising to 0.2 at the threshold, 0.8 just above it and 0.95 at the threshold plus the edge.
struct EchoRampConfig {
    double threshold = 0.2;  ///< normalised intensity, [0,1]
    double edge = 0.05;      ///< width of the ramp to either side, normalised intensity, [0,1]
    friend bool operator==(const EchoRampConfig&, const EchoRampConfig&) = default;
};

/// Their tables; the argument only selects one.
[[nodiscard]] std::span<const Parameter<FetalPresetConfig>> parametersOf(const FetalPresetConfig&);
[[nodiscard]] std::span<const Parameter<EchoRampConfig>> parametersOf(const EchoRampConfig&);

/// The same curve for every volume. How many voxels of input.shown it shows is a fact; where it shows none, the message
/// says so. The result is empty only where progress.cancel was raised. Throws std::invalid_argument where the volumes
/// have different grids.
[[nodiscard]] std::optional<Design> design(const FetalPresetConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});
/// The same for the echo ramp: what of it lies beyond 0 or 1 is cut off there. It throws, too, where a parameter is out
/// of its range.
[[nodiscard]] std::optional<Design> design(const EchoRampConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
