// Where a NIfTI volume lies: sform, qform or voxel sizes alone, turned from NIfTI's RAS into LPS.
#pragma once

#include <string>

#include "io/nifti/nifti_header.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Sets size, spacing, origin and direction of `stored`, and adds facts and notes. The first three dimensions of the
/// header must be whole numbers above 0. sform counts if its code is above 0 and it is a geometry; else qform, by the
/// same rule; else the voxel sizes alone, without a patient frame. A form that has a code and is no geometry is noted.
/// A unit that is no length makes the spacing unknown. Fails (unreadable, naming the field) if the voxel sizes are none
/// where they are needed, or if the spacing cannot be told.
[[nodiscard]] Result<void> placeNifti(const NiftiHeader& header, StoredVolume& stored);

}  // namespace echolucent
