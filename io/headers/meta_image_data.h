// Where the voxels of a MetaImage lie: behind the header, in one data file, in a list or a pattern of them.
#pragma once

#include <cstdint>

#include "io/headers/meta_image_keys.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Sets data, extent and dataAtEnd of `stored`, whose path, size, phases and encoding are set, by the keys of the
/// header `file` of 3 or 4 `dimensions`. Adds a note if a name could be taken for a pattern. Fails (unreadable) if the
/// keys name no files that can hold the voxels; no data file is opened.
[[nodiscard]] Result<void> placeMetaImageData(const InputFile& file, const MetaImageKeys& keys, std::int64_t dimensions,
                                              StoredVolume& stored);

}  // namespace echolucent
