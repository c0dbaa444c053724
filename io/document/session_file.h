// Session files: a document as JSON with its snapshots. They name the study so that both can move together.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/document/document_file.h"
#include "io/study/study_checksum.h"
#include "processing/document/saved_session.h"
#include "processing/result.h"

namespace echolucent {

/// The JSON of the document with one more key: {"session": {"snapshots": [{"name": ..., "document": {...}}], "file":
/// ...}}. "file" is missing if SavedSession::file is empty. Snapshots name no study. A program that reads documents
/// reads sessions too. Equal sessions give equal bytes. Throws as jsonOf() of a document.
[[nodiscard]] std::string jsonOf(const SavedSession& session);

/// The session that jsonOf() wrote as a text. A document without the key "session" is a session without snapshots.
/// Refusals are as in documentFromJson(). Names that problemOfSnapshotName() refuses, and more than mostSnapshots, are
/// refused too.
[[nodiscard]] Result<SavedSession> sessionFromJson(std::string_view text, const std::string& file = {});

/// Reads the file; paths in it stay as written.
[[nodiscard]] Result<SavedSession> readSession(const std::string& path);
/// Writes the file whole or not at all. Fails as writeDocument(), also for what snapshots hold.
[[nodiscard]] Result<void> writeSession(const std::string& path, const SavedSession& session);

/// Whether the file at `path` calls itself a document within its first 4096 bytes; false if it cannot be read.
[[nodiscard]] bool looksLikeDocument(const std::string& path);

/// The session with the study's path as a session file at `file` names it. The path is relative to the file's folder if
/// the study lies in that folder, below it, or below the folder above it; else absolute.
[[nodiscard]] SavedSession asNamedFrom(const std::string& file, SavedSession session);
/// The path of the study of a session file at `file`. A relative `path` starts at the file's folder. If it leads
/// nowhere from there, but somewhere from the working folder, it starts at the working folder.
[[nodiscard]] std::string studyPathFrom(const std::string& file, const std::string& path);

/// The study of a session file at `file`: at studyPathFrom() if it is there, else where findStudy() finds it in the
/// file's folder and by `search`. No value if it is not found.
[[nodiscard]] std::optional<std::string> placeOfStudy(const StudyFile& study, const std::string& file,
                                                      StudySearch search = {}, const Progress& progress = {});

/// The beginning of the names of files that belong to the study or session at `study`. Of a folder it is the whole
/// name. Of a file it is the name without its ending: "heart" of "heart.nii.gz" and of "heart.session.json".
[[nodiscard]] std::string stemOfStudy(const std::string& study);
/// Fails (wrong usage) if a session file at `file` would replace one of the study's `files`, or would lie in the folder
/// `study`.
[[nodiscard]] Result<void> refuseSessionInside(const std::string& study, const std::vector<std::string>& files,
                                               const std::string& file);

}  // namespace echolucent
