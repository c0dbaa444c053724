// What is true of a simulated scan, as JSON. docs/cli-phantom.md describes each field.
#pragma once

#include <string>
#include <vector>

#include "processing/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/viewpoint.h"

namespace echolucent::cli {

/// One JSON object, numbers round-trip, ends with a newline. `phases`: the config of each phase written, at least one.
/// Of `tubes` only grid, spacing and cell size matter.
[[nodiscard]] std::string truthReport(const std::vector<PhantomConfig>& phases, const Viewpoint& view,
                                      const AdaptiveOtfConfig& tubes);

}  // namespace echolucent::cli
