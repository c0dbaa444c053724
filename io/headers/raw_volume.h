// Reads raw files without a header, described by a person.
#pragma once

#include <string>
#include <string_view>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// Added to a raw file's name, it gives the name of its layout.
inline constexpr std::string_view rawLayoutEnding = ".echolucent.json";
/// The path of the layout of the raw file at `path`: FILE.echolucent.json beside it.
[[nodiscard]] std::string rawLayoutPath(const std::string& path);

/// Checks the `layout` of an opened raw file; no voxel is read. `source` tells where the layout came from: "--raw-size"
/// or the name of the file that holds the layout. Fails (unreadable) if the layout makes no sense.
[[nodiscard]] Result<StoredVolume> storedVolumeFromLayout(const InputFile& file, const RawLayout& layout,
                                                          const std::string& source);

}  // namespace echolucent
