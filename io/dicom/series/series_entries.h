// Sorts the headers of files into the series that a person chooses from, and keeps apart what must not be mixed.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/series/image_header.h"
#include "io/dicom/series/slice_groups.h"
#include "io/study/series_list.h"
#include "processing/progress.h"

namespace echolucent {

/// The entries, and what fits into none.
struct SortedSeries {
    std::vector<SeriesEntry> entries;   ///< as SeriesList::series, each with its own name
    std::vector<DamagedFile> leftOut;   ///< damaged files without a place in a volume
    std::vector<std::string> warnings;  ///< on different pictures with one Series Instance UID, and on copies
};

/// Sorts images into series. Slices of one Series Instance UID are listed apart if they differ in patient, frame of
/// reference, size, modality, photometric interpretation or pixel spacing, or if a few stand at angles to the others.
/// Copies are left out (dropCopies()); slices that lie at the same places again and again make up phases
/// (slicePhasesOf()); parts of one object are one entry; so are series of one place each (joinSeries()). A damaged
/// slice stands in its entry if its place is known and fits; else it is left out. Failures are about `folder` or about
/// one file. If `progress` is cancelled, the result makes no sense. Call it in a thread with a large stack.
[[nodiscard]] SortedSeries sortIntoSeries(const std::string& folder, std::vector<ImageHeader> images,
                                          std::vector<DamagedFile> damaged, const Progress& progress);

}  // namespace echolucent
