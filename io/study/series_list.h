// The series that a folder of DICOM files holds, as plain values to choose from, and the reading of the chosen one.
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
    std::int64_t instance = 0;        ///< Instance Number; 0 where it is missing
    std::optional<SlicePlane> plane;  ///< where its picture lies; no value where the file does not say it
    Rescale rescale{};                ///< its Rescale Slope and Intercept
    std::optional<Failure> damage{};  ///< why it cannot be read: its slice is no data; no value where it is whole
};

/// One choice: slices that make up a volume, or one multi-frame file.
struct SeriesEntry {
    /// Names the series in its list and in ReadOptions::series: the Series Instance UID. Where several entries share
    /// it, the one with most slices has it; a multi-frame file beside it has its SOP Instance UID, slices that are
    /// listed apart have ":COLUMNSxROWS" behind it.
    std::string uid;
    std::string object;       ///< SOP Instance UID of the first file
    std::string description;  ///< Series Description in UTF-8 or as stored; empty where it may name the patient
    std::string modality;     ///< "US"; empty where the files do not say it
    /// What tells its slices from others under the same Series Instance UID: "patient 1 of 2"; empty where all are one.
    std::string distinction;
    /// Columns, rows, and slices or frames; of a GE Voluson volume in a DICOM file those of the picture beside it.
    std::array<std::int64_t, 3> size{0, 0, 0};
    bool multiframe = false;        ///< whether it is one file: many frames, or a maker's private volume
    std::vector<SeriesFile> files;  ///< in the order of the slices where they can be stacked; never empty
    /// Why it cannot be opened, as far as its headers say it; no value where nothing is against it. Where
    /// `framesCouldBeSlices` is set, ReadOptions::framesAsSlices opens it all the same.
    std::optional<Failure> whyNot;
};

/// What a folder holds.
struct SeriesList {
    std::string path;                 ///< the folder or DICOMDIR, as the person gave it
    std::vector<SeriesEntry> series;  ///< those that can be opened first, most slices first; never empty once listed
    std::vector<std::string> files;   ///< all DICOM files found, those that cannot be read among them
    std::vector<std::string> warnings;
};

/// Whether the file or folder at `path` is one that listSeries() reads: a folder, or a DICOMDIR.
[[nodiscard]] bool holdsSeries(const std::string& path);

/// Reads the headers (not the pixels) of all DICOM files in the folder at `path` and the folders in it, four deep, each
/// once and in parallel; of a DICOMDIR those that it names in or below its own folder. Files that cannot be read are
/// named in a warning, and stand among the slices where their place is known. `progress` is polled for cancel between
/// files and between elements, and told the first 0.3 of what reading takes. Fails (unreadable) where there is no DICOM
/// image that can be read, (cancelled) where the person ended it.
[[nodiscard]] Result<SeriesList> listSeries(const std::string& path, const Progress& progress = {});

/// How large an entry is: "640 x 480, 90 slices".
[[nodiscard]] std::string sizeInWords(const SeriesEntry& entry);

/// The entry named `uid`; the first where `uid` is empty. Fails (unreadable, telling those that there are) where the
/// list holds no such series.
[[nodiscard]] Result<const SeriesEntry*> findSeries(const SeriesList& list, const std::string& uid);

/// Reads a listed series without looking at the folder again: `options.series` is not asked. Study::files are the
/// list's. Slices that cannot be read are no data, which a warning says. Fails (unreadable) where fewer than two, or
/// fewer than half of them, can be read.
[[nodiscard]] Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry,
                                       const ReadOptions& options = {}, const Progress& progress = {});

/// A small picture in grey: row after row, one byte a pixel, 0 is black.
struct SmallPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
};

/// The middle slice or frame of a series, made so small that no edge is longer than `longestEdge` pixels (above 0);
/// small pictures stay as they are. Its largest value is white. Fails where that picture cannot be read.
[[nodiscard]] Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge,
                                                 const Progress& progress = {});

}  // namespace echolucent
