// Reading a study and looking it through, in whichever thread asks for it. Knows no widget.
#pragma once

#include <functional>
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

/// What reading gave: a study, with the series beside it where there are several, or a list to choose from.
struct Opening {
    std::optional<Study> study{};
    std::shared_ptr<const SeriesList> series{};
    std::optional<OpenedSession> saved{};
    std::optional<SavedStudyProblem> problem{};
};

/// Reads what a person opened. A large study tells progress.coarse of itself before it is read where it can.
using StudyReader = std::function<Result<Opening>(const Progress&)>;

/// The reader of a file or a DICOM folder: of a folder of several series that name none in the options, the only volume
/// among them, or the list where there is none or more than one.
[[nodiscard]] StudyReader readerOf(const StudyFile& file);

/// An opening, and what was found of its study; nothing where there is no study.
struct LookedThrough {
    Opening opening;
    std::vector<IntensityHistogram> histograms{};  ///< by phase
    std::optional<OpeningFinds> finds{};           ///< nothing of simulated scans, whose beam is known
};

/// Reads a study and looks it through. A large study tells progress.coarse of itself once: before it is read, or where
/// it cannot be read in part, before it is looked through; sessions do not. `path` is what sentences name; it is empty
/// where the scan is simulated. Fails as the reader does, and (unreadable) where memory runs out.
[[nodiscard]] Result<LookedThrough> lookThrough(const StudyReader& read, const std::string& path,
                                                const Progress& progress);

}  // namespace echolucent
