// Drafts of lessons as folders, which the program keeps by itself: draft.json, and the lesson's images.
#pragma once

#include <string>

#include "processing/lesson/lesson_draft.h"
#include "processing/result.h"

namespace echolucent {

inline constexpr const char* lessonDraftFileName = "draft.json";

/// Writes a draft into a folder, each file whole or not at all; the folder is made if it is not there. Its lesson may
/// break any rule but that of its study, a simulated scan. Fails (unwritable) if it cannot be written.
[[nodiscard]] Result<void> writeLessonDraft(const std::string& folder, const LessonDraft& draft);
/// The draft that writeLessonDraft() wrote, whatever rules its lesson breaks. Fails (unreadable) if there is none, or
/// if it is damaged.
[[nodiscard]] Result<LessonDraft> readLessonDraft(const std::string& folder);

}  // namespace echolucent
