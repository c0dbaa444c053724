// The adaptive method as one of the designers.
#pragma once

#include <memory>
#include <optional>

#include "processing/designers/adaptive_config.h"
#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// An empty table: the parameters are the rows of methodParameters().
[[nodiscard]] const ParameterTable<AdaptiveConfig>& parametersOf(const AdaptiveConfig& config);

/// Runs adaptOpacity() (Petersch 2005; docs/method.md). Tube cores read the raw voxels along input.view, and the curve
/// is meant for the shown voxels. If no surface is found, the curve is the initial function, and `message` says so. The
/// result is empty only if progress.cancel was raised. Its bits are the same for any number of threads. Throws
/// std::invalid_argument if problemOf(input.method) is not empty or the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const AdaptiveConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// The same for a finished run; not null.
[[nodiscard]] Design designOf(std::shared_ptr<const AdaptiveOtf> otf);

}  // namespace echolucent
