// Headerless raw files, described by a person.
#pragma once

#include <string>
#include <string_view>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// What the name of a raw file's layout adds to the file's own.
inline constexpr std::string_view rawLayoutEnding = ".echolucent.json";
/// Where the layout of the raw file at `path` is kept: FILE.echolucent.json beside it.
[[nodiscard]] std::string rawLayoutPath(const std::string& path);

/// Checks the `layout` of an opened raw file; no voxel is read. `source` says where the layout came from: it is
/// "--raw-size" or the name of the file that holds it. Fails (unreadable) where the layout makes no sense.
[[nodiscard]] Result<StoredVolume> storedVolumeFromLayout(const InputFile& file, const RawLayout& layout,
                                                          const std::string& source);

}  // namespace echolucent
