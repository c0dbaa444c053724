// Reads NIfTI (.nii, or .hdr with .img; either packed with gzip). docs/formats-read.md says what is understood.
#pragma once

#include <optional>
#include <string>

#include "io/nifti/nifti_header.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Reads and checks the header at the beginning of an opened file. No voxel is read, but an .img.gz is unpacked. If
/// `framesAsSlices` is set, 2D frames over time are accepted as slices at an unknown distance. Fails (unreadable) if
/// the file does not begin with a NIfTI header (looksLikeNifti()), if the header cannot be read, or if its .img is
/// missing.
[[nodiscard]] Result<StoredVolume> readNiftiHeader(const InputFile& file, bool framesAsSlices,
                                                   const Progress& progress);

/// The .hdr or .hdr.gz of the same name beside the .img or .img.gz at `path`; no value if there is none, or if `path`
/// ends otherwise.
[[nodiscard]] std::optional<std::string> niftiHeaderBeside(const std::string& path);

}  // namespace echolucent
