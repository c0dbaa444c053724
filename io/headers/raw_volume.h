// Headerless raw files, described by a person.
#pragma once

#include "io/stored_volume.h"

namespace echolucent {

/// Where the layout of the raw file at `path` is kept: FILE.echolucent.json beside it.
[[nodiscard]] std::string rawLayoutPath(const std::string& path);

/// Checks a layout; no voxel is read. `source` says where it came from: "--raw-size" or the side-car's name.
[[nodiscard]] Result<StoredVolume> storedVolumeFromLayout(const std::string& path, const RawLayout& layout,
                                                          const std::string& source);

}  // namespace echolucent
