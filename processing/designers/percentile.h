// A ramp between two percentiles of the intensities as an OTF designer (docs/designers/percentile.md).
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/percentile_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Its table; the argument only selects it.
[[nodiscard]] const ParameterTable<PercentileConfig>& parametersOf(const PercentileConfig&);

/// A curve that is clear up to one percentile (percentileOf(), the nearest rank) of input.shown, full from the other
/// on, and straight between. Voxels without data do not count. If both percentiles are one intensity that many voxels
/// share, the voxels above it alone give the upper end. If there are none above, those below give the lower end. If all
/// data have one value, or there are none, the curve is x^2. The message tells each of these cases. The result is empty
/// only if progress.cancel was raised. Its bits are the same for any number of threads. Throws std::invalid_argument if
/// a parameter is out of its range or the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const PercentileConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
