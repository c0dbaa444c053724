// Reads NRRD (.nrrd, .nhdr). docs/formats-read.md says what is understood and what is refused.
#pragma once

#include "io/stored/stored_volume.h"

namespace echolucent {

/// The beginning of every NRRD file, up to the digit of its version.
constexpr std::string_view nrrdSignature = "NRRD000";

[[nodiscard]] bool looksLikeNrrd(std::string_view beginning);

/// Reads and checks the header of an opened file, but no voxel. If `framesAsSlices` is set, 2D frames over time and
/// tracked sweeps are accepted as slices at an unknown distance. Fails (unreadable) if the header is none or cannot be
/// read.
[[nodiscard]] Result<StoredVolume> readNrrdHeader(const InputFile& file, bool framesAsSlices);

}  // namespace echolucent
