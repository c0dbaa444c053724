// Reads the study that the header of a MetaImage, an NRRD, a NIfTI or a raw layout describes.
#pragma once

#include "io/stored/stored_volume.h"
#include "io/study/study.h"

namespace echolucent {

/// Reads the voxels that `stored` describes. Before memory is taken, the declared size is compared with the files.
/// Fails (unreadable) if they hold fewer voxels or are damaged. `progress` is polled for cancel.
[[nodiscard]] Result<Study> readStoredVolume(const StoredVolume& stored, const ReadOptions& options,
                                             const Progress& progress);

}  // namespace echolucent
