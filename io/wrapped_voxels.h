// What stands before the voxels in data files and is no voxel: headers of other formats, whatever "byte skip: -1"
// leaves out, and gzip, zlib or bzip2 that the header does not tell of.
#pragma once

#include "io/stored/stored_volume.h"

namespace echolucent {

/// Looks at the beginning of the voxels in every data file of `stored` and sets its encoding and skipBytes so that
/// reading begins with voxels. With a note for each thing found:
/// - A header of another format is skipped if the voxels fill exactly the rest.
/// - Raw voxels that begin like gzip or bzip2 and are not as many bytes as declared are unpacked.
/// - Raw voxels that begin like gzip, bzip2 or zlib are unpacked, however long, if they give exactly the bytes that are
///   declared, with their checksum.
///
/// Compressed voxels at the end of their stream (dataAtEnd) are found by counting. Fails (unreadable) if a header of
/// another format stands where voxels should and cannot be skipped, or if a file cannot be read or decoded; (cancelled)
/// if the person ended it.
[[nodiscard]] Result<void> settleBeginnings(StoredVolume& stored, const Progress& progress);

}  // namespace echolucent
