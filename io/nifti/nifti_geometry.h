// Where a NIfTI volume lies: sform, qform or voxel sizes alone, turned from NIfTI's RAS into LPS.
#pragma once

#include <string>

#include "io/nifti/nifti_header.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Sets size, spacing, origin and direction of `stored`, and adds facts and notes. The first three dimensions of the
/// header must be whole numbers above 0. sform counts if its code is above 0 and it is a geometry; else qform if its
/// code is above 0; else the voxel sizes alone, without a patient frame. Fails (unreadable, naming the field) if the
/// unit is no length, if qform is no geometry where it counts, or if sform is none and qform has no code.
[[nodiscard]] Result<void> placeNifti(const NiftiHeader& header, StoredVolume& stored);

}  // namespace echolucent
