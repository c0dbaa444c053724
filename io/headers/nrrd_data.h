// Where the voxels of an NRRD file lie: in the file itself, in one data file, in a list or a pattern of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/headers/nrrd_fields.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Sets data, extent, skips and dataAtEnd of `stored`, whose path and encoding are set, by the fields of the header
/// `file`; `sizes` are those of all axes. Adds a note if a name could be taken for a pattern. Fails (unreadable) if the
/// fields name no files that can hold the voxels; no data file is opened.
[[nodiscard]] Result<void> placeNrrdData(const InputFile& file, const NrrdFields& fields,
                                         const std::vector<std::int64_t>& sizes, StoredVolume& stored);

}  // namespace echolucent
