// The series of a folder of DICOM files, as plain values to choose from, and the reading of the chosen one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/study/slice_stack.h"
#include "io/study/study.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

/// One file of a listed series.
struct SeriesFile {
    std::string path;
    std::int64_t instance = 0;        ///< Instance Number; 0 if missing
    std::optional<SlicePlane> plane;  ///< place of its picture; no value if the file does not say it
    Rescale rescale{};                ///< its Rescale Slope and Intercept
    std::optional<Failure> damage{};  ///< why it cannot be read: its slice is no data; no value if it is whole
};

/// One choice: slices that make up a volume, or one multi-frame file.
struct SeriesEntry {
    /// Names the series in its list and in ReadOptions::series: the Series Instance UID. If several entries share it,
    /// the one with most slices keeps it. A multi-frame file beside it has its SOP Instance UID. Slices listed apart
    /// have ":COLUMNSxROWS" behind it.
    std::string uid;
    std::string object;       ///< SOP Instance UID of the first file
    std::string description;  ///< Series Description in UTF-8 or as stored; empty if it may name the patient
    std::string modality;     ///< "US"; empty if the files do not say it
    /// Tells its slices from others under the same Series Instance UID: "patient 1 of 2"; empty if all are one.
    std::string distinction;
    /// Columns, rows, and slices or frames. A GE Voluson volume in a DICOM file has those of the picture beside it.
    std::array<std::int64_t, 3> size{0, 0, 0};
    bool multiframe = false;        ///< whether it is one file: many frames, or a maker's private volume
    std::vector<SeriesFile> files;  ///< in the order of the slices if they can be stacked; never empty
    /// Why it cannot be opened, as far as its headers say; no value if nothing is against it. If `framesCouldBeSlices`
    /// is set, ReadOptions::framesAsSlices opens it all the same.
    std::optional<Failure> whyNot;
};

struct SeriesList {
    std::string path;                 ///< the folder or DICOMDIR, as the person gave it
    std::vector<SeriesEntry> series;  ///< the openable ones first, most slices first; never empty once listed
    std::vector<std::string> files;   ///< all DICOM files found, also unreadable ones
    std::vector<std::string> warnings;
};

/// Whether listSeries() reads the file or folder at `path`: a folder, or a DICOMDIR.
[[nodiscard]] bool holdsSeries(const std::string& path);

/// Reads the headers (not the pixels) of all DICOM files in the folder at `path` and its subfolders, four deep, each
/// once and in parallel. Of a DICOMDIR it reads the files named in or below its own folder. Unreadable files are named
/// in a warning, and stand among the slices if their place is known. `progress` is polled for cancel between files and
/// between elements, and told the first 0.3 of what reading takes. Fails (unreadable) if there is no readable DICOM
/// image, (cancelled) if the person ended it.
[[nodiscard]] Result<SeriesList> listSeries(const std::string& path, const Progress& progress = {});

/// The size of an entry: "640 x 480, 90 slices".
[[nodiscard]] std::string sizeInWords(const SeriesEntry& entry);

/// The entry named `uid`; the first if `uid` is empty. Fails (unreadable) if the list holds no such series; the
/// sentence lists those that there are.
[[nodiscard]] Result<const SeriesEntry*> findSeries(const SeriesList& list, const std::string& uid);

/// Reads a listed series without looking at the folder again, so `options.series` does not count. Study::files are the
/// list's. Unreadable slices are no data, and a warning says so. Fails (unreadable) if fewer than two, or fewer than
/// half of them, can be read.
[[nodiscard]] Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry,
                                       const ReadOptions& options = {}, const Progress& progress = {});

/// A small picture in grey: row after row, one byte a pixel, 0 is black.
struct SmallPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
};

/// The middle slice or frame of a series, reduced until no edge is longer than `longestEdge` pixels (above 0). Smaller
/// pictures stay as they are. Its largest value is white. Fails if that picture cannot be read.
[[nodiscard]] Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge,
                                                 const Progress& progress = {});

}  // namespace echolucent
