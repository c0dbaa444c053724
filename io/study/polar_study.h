// The step from a reader's polar voxels to a study: scan conversion, with its part of the import report.
#pragma once

#include <string>

#include "io/study/study_assembly.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent {

/// The keys, items or options of the numbers of a polar geometry, for the import report and for refusals.
struct PolarSources {
    std::string size;       ///< samples, lines and planes
    std::string range;      ///< place of the first sample, and distance of samples
    std::string lines;      ///< angles or positions of the lines, and the radius of their axis
    std::string planes;     ///< angles or positions of the planes, and the radius of their axis
    std::string assumed{};  ///< assumption on distances: "the first sample lies on the probe's face"; may be empty
};

/// Fails (unreadable) if the geometry makes no sense, or has other numbers of samples, lines or planes than `size`. The
/// sentence names `path` and `sources`.
[[nodiscard]] Result<void> checkPolar(const std::string& path, const PolarGeometry& polar,
                                      const std::array<std::int64_t, 3>& size, const PolarSources& sources);

/// Replaces the polar voxels of all phases by those of a Cartesian grid, within the memory that the options allow. Sets
/// geometry, probe, mask and the sources of size and spacing, and adds facts. Call checkPolar() before. Fails
/// (unreadable) if the machine has too little memory, or if the grid would be one voxel thick; (cancelled) if the
/// person ended it.
[[nodiscard]] Result<void> scanConvert(StudyParts& parts, const PolarGeometry& polar, const PolarSources& sources,
                                       const ReadOptions& options, const Progress& progress);

}  // namespace echolucent
