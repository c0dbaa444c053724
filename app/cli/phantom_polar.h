// The phantom command's volumes of voxels along beams.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/phantom/phantom_config.h"
#include "processing/result.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent::cli {

/// Whether the ending of a name asks for voxels along beams: .vol or .raw.
[[nodiscard]] bool isPolarName(const std::string& path);

/// The layout that is written beside a raw file; empty where the name is none of a raw file.
[[nodiscard]] std::string layoutBeside(const std::string& path);

/// The beams along which a scene is sampled for a file of that name; `kind` is the text of --polar. No value where it
/// is sampled on a Cartesian grid. Fails (wrong usage) where name, kind, phases and config do not go together.
[[nodiscard]] Result<std::optional<PolarGeometry>> polarOfPhantom(const std::string& path, const std::string& kind,
                                                                  int phases, const PhantomConfig& config);

/// Samples the phases of a scene along beams and writes them as a GE Voluson volume (.vol) or as a raw file with the
/// layout beside it (.raw). `phases` become the configs on the grid that the file is converted to when it is read
/// without options, so that the truth can be told in its voxels. Fails (unwritable) where a file cannot be written.
[[nodiscard]] Result<void> writePolarPhantom(const std::string& path, const PolarGeometry& polar,
                                             std::vector<PhantomConfig>& phases);

}  // namespace echolucent::cli
