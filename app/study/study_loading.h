// Reads a study and looks it through, in the caller's thread. Knows no widget.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/saved_study.h"
#include "io/study/series_list.h"
#include "io/study/study.h"
#include "processing/document/opening_finds.h"
#include "processing/document/study_reference.h"
#include "processing/intensity/histogram.h"
#include "processing/progress.h"

namespace echolucent {

/// The result of reading: a study, a list of series to choose from, or a problem with a session's study.
struct Opening {
    std::optional<Study> study{};
    std::shared_ptr<const SeriesList> series{};  ///< beside a study: the series of its folder, if there are several
    std::optional<OpenedSession> saved{};        ///< the session that names the study, if one was opened
    std::optional<SavedStudyProblem> problem{};
};

/// Reads what a person opened. If it can, it gives a large study's coarse volume to progress.coarse before reading it.
using StudyReader = std::function<Result<Opening>(const Progress&)>;

/// The reader of a file or a DICOM folder. If a folder holds several series and the options name none, it reads the
/// only volume among them. If there is no volume or more than one, or if the only one cannot be read, it gives the
/// list.
[[nodiscard]] StudyReader readerOf(const StudyFile& file);

/// A kind of scan: format, maker and model, as far as the study says them. It holds nothing of a patient.
[[nodiscard]] std::string kindOfScan(const Study& study);
/// The sides that a person took last, as words (Side::word), by kindOfScan().
using SidesByKind = std::map<std::string, std::string>;

/// An opening, and what was found of its study; empty without a study.
struct LookedThrough {
    Opening opening;
    std::vector<IntensityHistogram> histograms{};  ///< by phase
    std::optional<OpeningFinds> finds{};           ///< no value for simulated scans, whose beam is known
};

/// Reads a study and looks it through. Of a large study, progress.coarse is told once: before it is read, or, if it
/// cannot be read in part, before it is looked through. Sessions do not tell it. If `taken`
/// holds sides, it is told only once the study is known to be of none of their kinds: else another side might be seen
/// at first. `path` is for sentences; it is empty if the scan is simulated. Fails
/// as the reader does, and (unreadable) if memory runs out or the file system fails.
[[nodiscard]] Result<LookedThrough> lookThrough(const StudyReader& read, const std::string& path,
                                                const Progress& progress, const SidesByKind& taken = {});

}  // namespace echolucent
