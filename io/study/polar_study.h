// The step between a reader of polar voxels and the study: scan conversion, with its part of the import report.
#pragma once

#include <string>

#include "io/study/study_assembly.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent {

/// The keys, items or options that gave the numbers of a polar geometry, for the import report and for refusals.
struct PolarSources {
    std::string size;       ///< samples, lines and planes
    std::string range;      ///< where the first sample lies, and how far one is from the next
    std::string lines;      ///< angles or positions of the lines, and the radius of their axis
    std::string planes;     ///< the same of the planes
    std::string assumed{};  ///< what the reader assumes of distances, for the report: "the first sample lies on the
                            ///< probe's face"; empty where the file says all
};

/// Fails (unreadable) where the geometry makes no sense or is not that of `size` samples, lines and planes. `path` and
/// `sources` are named in the sentence.
[[nodiscard]] Result<void> checkPolar(const std::string& path, const PolarGeometry& polar,
                                      const std::array<std::int64_t, 3>& size, const PolarSources& sources);

/// Replaces the voxels of all phases, which are those of a polar volume in its index order, by those of a Cartesian
/// grid within the memory that the options allow. Sets geometry, probe, mask and spacing source, and adds facts. The
/// geometry has been checked with checkPolar(). Fails (unreadable) where the machine has too little memory, (cancelled)
/// where the person ended it.
[[nodiscard]] Result<void> scanConvert(StudyParts& parts, const PolarGeometry& polar, const PolarSources& sources,
                                       const ReadOptions& options, const Progress& progress);

}  // namespace echolucent
