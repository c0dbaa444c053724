// Curves that users of 3D Slicer know, as OTF designers. They depend on no voxel (docs/designers/fetal-preset.md and
// docs/designers/echo-ramp.md).
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/fixed_presets_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Their tables; the argument only selects one.
[[nodiscard]] const ParameterTable<FetalPresetConfig>& parametersOf(const FetalPresetConfig&);
[[nodiscard]] const ParameterTable<EchoRampConfig>& parametersOf(const EchoRampConfig&);

/// The same curve for every volume. A fact tells how many voxels of input.shown it shows; if it shows none, the message
/// says so. The result is empty only if progress.cancel was raised. Throws std::invalid_argument if the volumes have
/// different grids.
[[nodiscard]] std::optional<Design> design(const FetalPresetConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});
/// The same for the echo ramp, cut off at 0 and 1. It also throws if a parameter is out of range.
[[nodiscard]] std::optional<Design> design(const EchoRampConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
