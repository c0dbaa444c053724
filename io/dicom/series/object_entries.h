// The entries of objects of many frames: one file each, or the parts of a concatenation.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/series/copies.h"
#include "io/dicom/series/series_traits.h"
#include "io/study/series_list.h"
#include "processing/progress.h"

namespace echolucent {

/// One entry for each object of a series: those of one file in the order of their paths, then those in parts in the
/// order of their UIDs. Parts are joined in their order (arrangeParts()); if one is missing, the entry's whyNot names
/// it. Copies are left out and added to `copies`. Two files of one identity that differ are both refused. Call it in a
/// thread with a large stack.
[[nodiscard]] std::vector<SeriesEntry> objectEntries(const std::string& folder, Images images, LeftOutCopies& copies,
                                                     const Progress& progress);

}  // namespace echolucent
