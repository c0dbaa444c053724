// The adaptive method as one of the designers.
#pragma once

#include <memory>
#include <optional>

#include "processing/designers/adaptive_config.h"
#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// No row: the rows of methodParameters() are its parameters.
[[nodiscard]] const ParameterTable<AdaptiveConfig>& parametersOf(const AdaptiveConfig& config);

/// Runs adaptOpacity() (Petersch 2005; docs/method.md): tube cores read the raw voxels along input.view, and the curve
/// is meant for the shown ones. Where no surface is found the curve is the initial function, and `message` says so. The
/// result is empty only where progress.cancel was raised, and has the same bits for any number of threads. Throws
/// std::invalid_argument where problemOf(input.method) is not empty, or where the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const AdaptiveConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// The same of a run whose result is there already; not null.
[[nodiscard]] Design designOf(std::shared_ptr<const AdaptiveOtf> otf);

}  // namespace echolucent
