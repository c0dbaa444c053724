// The header of an object that is kept in several files (a concatenation), as if it stood in one.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/elements/dicom_file.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// The header of the first file, without pixels, with the frames of all: Number of Frames is their sum, and so are the
/// Per-frame Functional Groups and the attributes that hold a value a frame. Where the groups of all frames differ from
/// part to part, each frame keeps those of its own part. `paths` holds the parts in their order, at least one. Fails
/// (unreadable) if a part cannot be read, if it is of another size, kind or depth than the first, or if the groups are
/// too many; (cancelled) if the person ended it. Call it in a thread with a large stack.
[[nodiscard]] Result<DicomFile> joinedHeader(const std::vector<std::string>& paths, const Progress& progress);

}  // namespace echolucent
