// From the headers of files to the series that a person chooses from: what belongs together, and what must not be
// mixed.
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
    std::optional<ImageHeader> header;  ///< what could still be read of it
};

/// Entries, and what could not be put into any.
struct SortedSeries {
    std::vector<SeriesEntry> entries;   ///< as SeriesList::series, each with a name of its own
    std::vector<DamagedFile> leftOut;   ///< damaged files that have no place in a volume
    std::vector<std::string> warnings;  ///< sentences on pictures that share a Series Instance UID and nothing more
};

/// Sorts images into series. Slices of one Series Instance UID are listed apart where they differ in patient, frame of
/// reference, size, modality, photometric interpretation or pixel spacing. A damaged slice stands in the entry that it
/// belongs to where its place is known and fits; it is left out else. Failures are about `folder` or about one file.
[[nodiscard]] SortedSeries sortIntoSeries(const std::string& folder, std::vector<ImageHeader> images,
                                          std::vector<DamagedFile> damaged);

/// Why a series of which `damaged` slices of `all` cannot be read is no volume; no value where enough are whole: two,
/// and half of them. `damaged` are the paths, `first` is what is wrong with the first.
[[nodiscard]] std::optional<Failure> tooFewWhole(const std::string& folder, const std::vector<std::string>& damaged,
                                                 std::size_t all, const Failure& first);

}  // namespace echolucent
