// Where a NIfTI volume lies: sform, qform or voxel sizes alone, turned from NIfTI's RAS into LPS.
#pragma once

#include <string>

#include "io/nifti/nifti_header.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Sets size, spacing, origin and direction of `stored` from a header whose first three dimensions are whole numbers
/// above 0, and adds the facts and notes on them. sform counts where its code is above 0, else qform where its code is,
/// else the voxel sizes alone, which know no patient. Fails (unreadable, naming the field) where what counts is no
/// geometry.
[[nodiscard]] Result<void> placeNifti(const NiftiHeader& header, StoredVolume& stored);

}  // namespace echolucent
