// Reading a session file together with the study that it names.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/output/overwriting.h"
#include "io/study/series_list.h"
#include "io/study/study.h"
#include "io/study/study_checksum.h"
#include "processing/document/saved_session.h"

namespace echolucent {

/// What a person answered where a session's study was not found as it was saved.
struct SavedStudyAnswer {
    std::string study{};       ///< path of the study; empty: where the session says, or where it is found
    bool evenChanged = false;  ///< the study is opened although its bytes are others
};

/// A session and the file that holds it; the study's path is one that can be opened.
struct OpenedSession {
    std::string file;
    SavedSession session;
};

/// A session whose study is open.
struct ReadSession {
    OpenedSession opened;  ///< with the checksum of what was read
    Study study;
    std::shared_ptr<const SeriesList> series{};  ///< of the study's folder; null where that holds no other
};

/// Why a session's study is not opened without asking.
struct SavedStudyProblem {
    enum class Kind {
        missing,  ///< it is neither in its place nor where it was looked for
        changed,  ///< its bytes are others than those that were saved
    };
    Kind kind = Kind::missing;
    std::string file;    ///< of the session
    std::string study;   ///< path of the study
    std::string change;  ///< as changeOf(); empty where it is missing
};

using SavedReading = std::variant<ReadSession, SavedStudyProblem>;

/// Reads a session file and its study, which is looked for by its bytes in the file's folder and by `search` where it
/// is not in its place. Fails where one of them cannot be read, where the window has no room for what the document
/// shows (a phase that the study does not have), and (cancelled) where the person ended it.
[[nodiscard]] Result<SavedReading> readSaved(const std::string& file, const SavedStudyAnswer& answer,
                                             StudySearch search, const Progress& progress);

/// Keeps what a study was read from, with the session that names it, if one does: no output takes the place of the
/// voxels; the layout beside a raw file and the session are saved again under their names.
[[nodiscard]] std::vector<KeptFiles> filesRead(const Study& study, const std::optional<OpenedSession>& saved);

}  // namespace echolucent
