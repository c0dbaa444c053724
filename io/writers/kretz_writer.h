// Writes polar volumes as GE Voluson (Kretz) files.
#pragma once

#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent {

/// The bytes of a Kretz volume; each phase's voxels are in the geometry's index order. Several phases become a sequence
/// item, and the first one a volume item too. The geometry must have no problem, lines and planes at angles, and at
/// most 65,535 samples, lines and planes. Throws std::invalid_argument if it has not, if there is no phase, if one has
/// another size, or if all take 4 GiB or more.
[[nodiscard]] std::string kretzBytes(const PolarGeometry& polar, const std::vector<std::vector<std::uint8_t>>& phases);

/// Writes kretzBytes() to `path`, whole or not at all. Fails (unwritable) if it cannot be written.
[[nodiscard]] Result<void> writeKretz(const std::string& path, const PolarGeometry& polar,
                                      const std::vector<std::vector<std::uint8_t>>& phases);

}  // namespace echolucent
