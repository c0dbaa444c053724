// The table of the method's parameters. Range check, command line, JSON and panel read it; docs/cli-otf.md lists it.
#pragma once

#include <string>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

/// The most tube cores of a grid: columns times rows.
inline constexpr int mostTubeCores = 1 << 18;

/// All parameters of an AdaptiveOtfConfig, except the kind and shape of its initial function and the tube cores that
/// are never placed. To add one, add a field to a rule (processing/tube_core/rules/) and a row to
/// method_parameters.cpp. Changing the number of columns or rows empties TubeGrid::withoutTubes.
[[nodiscard]] const ParameterTable<AdaptiveOtfConfig>& methodParameters();

/// What is out of range in a config: lower case, no full stop ("the cell size must be 2 to 32"); empty if nothing is.
[[nodiscard]] std::string problemOf(const AdaptiveOtfConfig& config);

}  // namespace echolucent
