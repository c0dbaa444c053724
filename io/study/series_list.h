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
    std::optional<SlicePlane> plane;  ///< place of the file's picture; no value if the file does not say it
    Rescale rescale{};                ///< Rescale Slope and Intercept of a single picture; else the identity
    bool padded = false;              ///< whether a single picture states the value of pixels that are no data
    /// Why the file cannot be read, so that its slice is no data; no value if it is whole.
    std::optional<Failure> damage{};
};

/// How the slices of an entry make up phases.
struct SeriesPhases {
    std::int64_t count = 1;       ///< at least 1
    std::vector<double> seconds;  ///< of each phase since the first, rising from 0; empty if the files do not say it
    std::string source;           ///< the attribute that told the phases apart; empty for one phase
    std::string timeSource;       ///< the attribute that gives `seconds`; empty if they are unknown
};

/// One choice: slices that make up a volume or its phases, one multi-frame file, or the parts of one such object.
struct SeriesEntry {
    /// Names the series in its list and in ReadOptions::series: the Series Instance UID, or "unnamed" if it has none.
    /// If several entries share a UID, the first in the list keeps it. A multi-frame file behind that one has its SOP
    /// Instance UID instead. Slices behind it have ":COLUMNSxROWS" after the UID. Names that are still the same get
    /// ":2" and so on.
    std::string uid;
    std::string object;       ///< SOP Instance UID of one of the files
    std::string description;  ///< Series Description in UTF-8 or as stored; empty if it may name the patient
    std::string modality;     ///< "US"; empty if the files do not say it
    /// Tells the slices of this entry from others under the same Series Instance UID: "patient 1 of 2"; empty if there
    /// are no others.
    std::string distinction;
    /// Of slices. Each phase has size[2] of them.
    SeriesPhases phases{};
    /// Columns, rows, and slices or frames. A GE Voluson volume in a DICOM file has those of the picture beside it.
    std::array<std::int64_t, 3> size{0, 0, 0};
    bool multiframe = false;  ///< whether the entry is one object: many frames, or a maker's private volume
    /// Phase after phase, each in the order of the slices if they can be stacked, else of their instance numbers. A
    /// multi-frame object has one file, or one for each of its parts, in their order. Never empty.
    std::vector<SeriesFile> files;
    std::vector<std::string> notes{};  ///< sentences on how the files were put together
    /// Why the series cannot be opened, as far as its headers say; no value if nothing is against it. If
    /// Failure::framesCouldBeSlices is set, ReadOptions::framesAsSlices opens the series all the same.
    std::optional<Failure> whyNot;
};

struct SeriesList {
    std::string path;  ///< the folder or DICOMDIR, as the person gave it
    /// The openable ones first, of these first those of one Series Instance UID, most slices first; never empty once
    /// listed.
    std::vector<SeriesEntry> series;
    /// The DICOMDIR, and all files found but those that are packed or no DICOM; also empty and unreadable ones.
    std::vector<std::string> files;
    std::vector<std::string> warnings;
};

/// Whether listSeries() reads the file or folder at `path`: a folder, or a DICOMDIR.
[[nodiscard]] bool holdsSeries(const std::string& path);

/// Reads the headers (not the pixels) of all DICOM files in the folder at `path` and its subfolders, four deep, each
/// once and in parallel. Of a DICOMDIR it reads the files named in or below its own folder. An unreadable file stands
/// among the slices if its place is known; else a warning names it. `progress` is polled for cancel between files and
/// between elements, and told the first 0.3 of what reading takes. Fails (unreadable) if there is no readable DICOM
/// image, (cancelled) if the person ended it.
[[nodiscard]] Result<SeriesList> listSeries(const std::string& path, const Progress& progress = {});

/// The size of an entry: "640 x 480, 90 slices".
[[nodiscard]] std::string sizeInWords(const SeriesEntry& entry);

/// The entry named `uid`; the first if `uid` is empty. Fails (unreadable) if the list holds no such series; the
/// sentence lists those that there are.
[[nodiscard]] Result<const SeriesEntry*> findSeries(const SeriesList& list, const std::string& uid);

/// Reads a listed series without looking at the folder again, so `options.series` does not count. Study::files are the
/// list's. Unreadable slices are no data, and a warning says so. Fails (unreadable) if fewer than two of the slices, or
/// fewer than half of them, can be read. Fails with SeriesEntry::whyNot if that stands against the series; (cancelled)
/// if the person ended it.
[[nodiscard]] Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry,
                                       const ReadOptions& options = {}, const Progress& progress = {});

/// A small picture in grey: row after row, one byte a pixel, 0 is black.
struct SmallPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
};

/// The middle slice or frame of a series, reduced until no edge is longer than `longestEdge` pixels (above 0). Smaller
/// pictures keep their size. The largest value is white. Fails if that slice or frame cannot be read, or if it has more
/// than 16 Mi pixels.
[[nodiscard]] Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge,
                                                 const Progress& progress = {});

}  // namespace echolucent
