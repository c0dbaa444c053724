// Session files: a document as JSON, with its snapshots, and the study named so that both can move together.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/document/document_file.h"
#include "io/study/study_checksum.h"
#include "processing/document/saved_session.h"
#include "processing/result.h"

namespace echolucent {

/// The JSON of the document with one more key: {"session": {"snapshots": [{"name": ..., "document": {...}}]}}, so that
/// whoever reads documents reads it too. Equal sessions give equal bytes.
[[nodiscard]] std::string jsonOf(const SavedSession& session);

/// The session of a text that jsonOf() wrote: an equal one. A document without the key "session" is one without
/// snapshots. What is refused is as in documentFromJson(); snapshots are named as problemOfSnapshotName() says, and
/// there are at most mostSnapshots.
[[nodiscard]] Result<SavedSession> sessionFromJson(std::string_view text, const std::string& file = {});

/// Reads the file as it is: paths in it stay as they are written.
[[nodiscard]] Result<SavedSession> readSession(const std::string& path);
/// Writes the file whole or not at all.
[[nodiscard]] Result<void> writeSession(const std::string& path, const SavedSession& session);

/// Whether the file at `path` says of itself that it is a document; false where it cannot be read.
[[nodiscard]] bool looksLikeDocument(const std::string& path);

/// The session with the study's path as a session file at `file` names it: relative to the file's folder where the
/// study lies in that folder, below it, or below the folder above it; absolute elsewhere.
[[nodiscard]] SavedSession asNamedFrom(const std::string& file, SavedSession session);
/// Where the study of a session file at `file` is: its path, where that is relative, from the file's folder. A relative
/// path that leads nowhere from there is one from the working folder, if it leads somewhere.
[[nodiscard]] std::string studyPathFrom(const std::string& file, const std::string& path);

/// The study of a session file at `file` where it is there, as studyPathFrom(); else what findStudy() finds in the
/// file's folder and by `search`. No value where that finds nothing.
[[nodiscard]] std::optional<std::string> placeOfStudy(const StudyFile& study, const std::string& file,
                                                      StudySearch search = {}, const Progress& progress = {});

/// What names of files begin with that belong to the study or the session at `study`: its own name without its ending,
/// "heart" of "heart.nii.gz" and of "heart.session.json", and of a folder its whole name.
[[nodiscard]] std::string stemOfStudy(const std::string& study);
/// Fails (wrong usage) where a session file at `file` would take the place of one of the files that a study was read
/// from, or would lie in the folder at `study`, where that is a folder.
[[nodiscard]] Result<void> refuseSessionInside(const std::string& study, const std::vector<std::string>& files,
                                               const std::string& file);

}  // namespace echolucent
