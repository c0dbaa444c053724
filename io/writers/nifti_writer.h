// Writes volumes as NIfTI-1, in one file with their header.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Writes one volume, or the phases of a moving one (time as fourth dimension), as NIfTI-1; as gzip where the path ends
/// in ".gz". Voxels keep their type and values. Geometry is turned into RAS and stands in sform and, where the axes are
/// perpendicular, in qform, with the code of a scanner's frame; spacing, origin, direction and white level are rounded
/// to float32. Without a known spacing pixdim is 0 and no frame is stated. The white level stands in cal_max and, for
/// readers that trust no display range, in descrip (niftiWhiteText()). `phaseSeconds` goes into pixdim[4]. All phases
/// have the first one's geometry. Throws std::invalid_argument where there are no phases or phases of different sizes
/// or types. Fails (unwritable) where the file cannot be written or an edge is longer than NIfTI-1's 32767 voxels.
[[nodiscard]] Result<void> writeNifti(const std::string& path, const std::vector<std::shared_ptr<const Volume>>& phases,
                                      std::optional<double> phaseSeconds = std::nullopt);

}  // namespace echolucent
