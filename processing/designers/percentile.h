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

/// A curve that is clear up to one percentile (percentileOf(), the nearest rank) of input.shown and full from the other
/// on, in a straight line between. Where both are one intensity that many voxels share, the voxels above it alone give
/// the upper end, or, where there are none, those below it the lower one, and the message says so. Where all data have
/// one value, or there are none, the curve is x^2, which the message says, too. Voxels without data do not count.
/// The result is empty only where progress.cancel was raised, and has the same bits for any number of threads. Throws
/// std::invalid_argument where a parameter is out of its range or the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const PercentileConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
