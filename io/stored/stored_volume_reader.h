// From the header of a MetaImage, an NRRD, a NIfTI or a raw layout to the study that its voxels make.
#pragma once

#include "io/stored/stored_volume.h"
#include "io/study/study.h"

namespace echolucent {

/// Reads the voxels that `stored` describes. The declared size is compared with what the file can hold before memory is
/// taken. Fails (unreadable) where the file holds fewer voxels or is damaged. `progress` is polled for cancel.
[[nodiscard]] Result<Study> readStoredVolume(const StoredVolume& stored, const ReadOptions& options,
                                             const Progress& progress);

}  // namespace echolucent
