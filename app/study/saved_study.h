// Reads a session file together with its study.
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

/// A person's answer if a session's study was not found as it was saved.
struct SavedStudyAnswer {
    std::string study{};       ///< path of the study; if empty, the session's path or a found one
    bool evenChanged = false;  ///< opens the study although its bytes have changed
};

/// A session and its file. The study's path in it can be opened.
struct OpenedSession {
    std::string file;
    SavedSession session;
};

/// A session whose study is open.
struct ReadSession {
    OpenedSession opened;  ///< with the checksum of what was read
    Study study;
    std::shared_ptr<const SeriesList> series{};  ///< of the study's folder; null if that holds no other
};

/// Why a person must be asked before a session's study is opened.
struct SavedStudyProblem {
    enum class Kind {
        missing,  ///< it is not in its place, and the search did not find it
        changed,  ///< its bytes are not those that were saved
    };
    Kind kind = Kind::missing;
    std::string file;    ///< of the session
    std::string study;   ///< path of the study
    std::string change;  ///< as changeOf(); empty if missing
};

using SavedReading = std::variant<ReadSession, SavedStudyProblem>;

/// Reads a session file and its study. If the study is not in its place, it is looked for by its bytes, in the file's
/// folder and by `search`. Gives a SavedStudyProblem if the study is not found, or if its bytes have changed and
/// `answer` does not allow that. Fails if session or study cannot be read, if the session names no study, or if its
/// document or a snapshot asks for a phase that the study does not have. Fails (cancelled) if progress.cancel was
/// raised.
[[nodiscard]] Result<SavedReading> readSaved(const std::string& file, const SavedStudyAnswer& answer,
                                             StudySearch search, const Progress& progress);

/// Keeps the files of a study, and of the session that names it, if any. No output may replace the voxels. The layout
/// beside a raw file and the session may be saved again under their names.
[[nodiscard]] std::vector<KeptFiles> filesRead(const Study& study, const std::optional<OpenedSession>& saved);

}  // namespace echolucent
