// The truth of a simulated scan as JSON. docs/cli-phantom.md describes each field.
#pragma once

#include <string>
#include <vector>

#include "processing/phantom/phantom.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent::cli {

/// One JSON object that ends with a newline. Its numbers are read back without loss. `phases` are the configs of the
/// written phases, at least one. `cellSize` is the width of a tube core in units.
[[nodiscard]] std::string truthReport(const std::vector<PhantomConfig>& phases, const Viewpoint& view,
                                      const TubeGrid& tubes, int cellSize);

}  // namespace echolucent::cli
