// Writes volumes as NIfTI-1, in one file with their header.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Writes one volume, or the phases of a moving one (time is the fourth dimension), as NIfTI-1; as gzip if the path
/// ends in ".gz". Voxels keep their type and values. The geometry, turned into RAS, stands in sform with the code of a
/// scanner's frame, and in qform too if the axes are perpendicular. Spacing, origin, direction and white level are
/// rounded to float32. If the spacing is not known, pixdim is 0 and there is no frame. The white level stands in
/// cal_max and descrip (niftiWhiteText()), `phaseSeconds` in pixdim[4]. All phases get the first one's geometry. Throws
/// std::invalid_argument if there is no phase, or if phases differ in size or type. Fails (unwritable) if the file
/// cannot be written, or if an edge or the number of phases exceeds NIfTI-1's 32767.
[[nodiscard]] Result<void> writeNifti(const std::string& path, const std::vector<std::shared_ptr<const Volume>>& phases,
                                      std::optional<double> phaseSeconds = std::nullopt);

}  // namespace echolucent
