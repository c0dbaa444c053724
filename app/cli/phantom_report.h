// What is true of a simulated scan, as JSON. docs/cli-phantom.md describes each field.
#pragma once

#include <string>
#include <vector>

#include "processing/phantom/phantom.h"
#include "processing/tube_core/tube_grid.h"
#include "processing/viewpoint.h"

namespace echolucent::cli {

/// One JSON object, numbers round-trip, ends with a newline. `phases`: the config of each phase written, at least one.
/// cellSize: width of a tube core, units.
[[nodiscard]] std::string truthReport(const std::vector<PhantomConfig>& phases, const Viewpoint& view,
                                      const TubeGrid& tubes, int cellSize);

}  // namespace echolucent::cli
