// Reads NRRD (.nrrd, .nhdr): docs/formats-read.md says what is understood and what is refused.
#pragma once

#include "io/stored/stored_volume.h"

namespace echolucent {

/// What every NRRD file begins with, before the digit of its version.
constexpr std::string_view nrrdSignature = "NRRD000";

/// Whether a file begins as NRRD files do.
[[nodiscard]] bool looksLikeNrrd(std::string_view beginning);

/// Reads and checks the header of an opened file; no voxel is read. Where `framesAsSlices` is set, 2D frames over time
/// and tracked sweeps are accepted as a volume of unknown spacing.
[[nodiscard]] Result<StoredVolume> readNrrdHeader(const InputFile& file, bool framesAsSlices);

}  // namespace echolucent
