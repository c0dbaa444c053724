// Writes polar volumes as GE Voluson (Kretz) files.
#pragma once

#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent {

/// The bytes of a Kretz volume: the voxels of each phase in the index order of the geometry. Several phases stand in
/// the item of a sequence, the first of them in that of a volume too. Throws std::invalid_argument where there is no
/// phase, where a phase has another size, where the geometry has a problem or more than 65,535 samples, lines or
/// planes, or where its lines or planes do not stand at angles, which the format always does.
[[nodiscard]] std::string kretzBytes(const PolarGeometry& polar, const std::vector<std::vector<std::uint8_t>>& phases);

/// Writes kretzBytes() to `path`, whole or not at all; fails (unwritable) where it cannot be written.
[[nodiscard]] Result<void> writeKretz(const std::string& path, const PolarGeometry& polar,
                                      const std::vector<std::vector<std::uint8_t>>& phases);

}  // namespace echolucent
