// Reads MetaImage (.mha, .mhd). docs/formats-read.md says what is understood and what is refused.
#pragma once

#include "io/stored/stored_volume.h"

namespace echolucent {

/// Whether the beginning of a file looks like a MetaImage header.
[[nodiscard]] bool looksLikeMetaImage(std::string_view beginning);

/// Reads and checks the header of an opened file, but no voxel. If `framesAsSlices` is set, 2D frames over time and
/// tracked sweeps are accepted as slices at an unknown distance. Fails (unreadable) if the header is none or cannot be
/// read.
[[nodiscard]] Result<StoredVolume> readMetaImageHeader(const InputFile& file, bool framesAsSlices);

}  // namespace echolucent
