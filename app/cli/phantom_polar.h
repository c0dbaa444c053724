// The phantom command's volumes with voxels along beams.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/phantom/phantom_config.h"
#include "processing/result.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent::cli {

/// Whether a name's ending asks for voxels along beams: .vol or .raw.
[[nodiscard]] bool isPolarName(const std::string& path);

/// The layout file beside a raw file; empty if the name is not a raw file's.
[[nodiscard]] std::string layoutBeside(const std::string& path);

/// The beams to sample a scene along for a file of that name; `kind` is the text of --polar. No value for a Cartesian
/// grid. Fails (wrong usage) if name, kind, phases and config do not fit together.
[[nodiscard]] Result<std::optional<PolarGeometry>> polarOfPhantom(const std::string& path, const std::string& kind,
                                                                  int phases, const PhantomConfig& config);

/// Samples the phases of a scene along beams. Writes them as a GE Voluson volume (.vol) or as a raw file with its
/// layout beside it (.raw). Read without options, that file is converted to a Cartesian grid. `phases` become the
/// configs on that grid, so that the truth can be told in its voxels. Fails (unwritable) if a file cannot be written.
[[nodiscard]] Result<void> writePolarPhantom(const std::string& path, const PolarGeometry& polar,
                                             std::vector<PhantomConfig>& phases);

}  // namespace echolucent::cli
