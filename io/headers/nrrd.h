// Reads NRRD (.nrrd, .nhdr): docs/formats-read.md says what is understood and what is refused.
#pragma once

#include "io/stored_volume.h"

namespace echolucent {

/// Whether a file begins as NRRD files do.
[[nodiscard]] bool looksLikeNrrd(std::string_view beginning);

/// Reads and checks the header; no voxel is read. Where `framesAsSlices` is set, two space axes
/// and a time axis are accepted as a volume.
[[nodiscard]] Result<StoredVolume> readNrrdHeader(const std::string& path, bool framesAsSlices);

}  // namespace echolucent
