// Reads MetaImage (.mha, .mhd): docs/formats-read.md says what is understood and what is refused.
#pragma once

#include "io/stored_volume.h"

namespace echolucent {

/// Whether the beginning of a file looks like a MetaImage header.
[[nodiscard]] bool looksLikeMetaImage(std::string_view beginning);

/// Reads and checks the header; no voxel is read.
[[nodiscard]] Result<StoredVolume> readMetaImageHeader(const std::string& path);

}  // namespace echolucent
