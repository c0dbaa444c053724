// Sorts the headers of files into the series that a person chooses from, and keeps apart what must not be mixed.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/series/image_header.h"
#include "io/study/series_list.h"

namespace echolucent {

/// A file that cannot be read.
struct DamagedFile {
    std::string path;
    Failure damage;
    std::optional<ImageHeader> header;  ///< what could still be read
};

/// The entries, and what fits into none.
struct SortedSeries {
    std::vector<SeriesEntry> entries;   ///< as SeriesList::series, each with its own name
    std::vector<DamagedFile> leftOut;   ///< damaged files without a place in a volume
    std::vector<std::string> warnings;  ///< sentences on different pictures with one Series Instance UID
};

/// Sorts images into series. Slices of one Series Instance UID are listed apart if they differ in patient, frame of
/// reference, size, modality, photometric interpretation or pixel spacing. A damaged slice stands in its entry if its
/// place is known and fits; else it is left out. Failures are about `folder` or about one file.
[[nodiscard]] SortedSeries sortIntoSeries(const std::string& folder, std::vector<ImageHeader> images,
                                          std::vector<DamagedFile> damaged);

/// Why a series is no volume if `damaged` slices of `all` cannot be read. No value if enough can be read: at least two,
/// and at least half of them. `damaged` holds the paths; `first` is the failure of the first.
[[nodiscard]] std::optional<Failure> tooFewWhole(const std::string& folder, const std::vector<std::string>& damaged,
                                                 std::size_t all, const Failure& first);

}  // namespace echolucent
