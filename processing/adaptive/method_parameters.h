// The method's parameters, each said once: range check, command line, JSON, docs/cli-otf.md and panel read this table.
#pragma once

#include <string>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

/// All parameters of an AdaptiveOtfConfig but the kind and shape of its initial function and the tube cores that are
/// never placed. A new one is a field of a rule (processing/tube_core/rules/) and a row in method_parameters.cpp.
/// Another number of columns or rows empties TubeGrid::withoutTubes.
[[nodiscard]] const ParameterTable<AdaptiveOtfConfig>& methodParameters();

/// What is out of range in a config, lower case, no full stop ("the cell size must be 2 to 32"), or an empty text where
/// nothing is.
[[nodiscard]] std::string problemOf(const AdaptiveOtfConfig& config);

}  // namespace echolucent
