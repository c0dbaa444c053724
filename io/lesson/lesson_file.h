// Lessons as folders: lesson.json, a text in Markdown for each language, pictures and sessions (docs/lessons.md).
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "processing/lesson/lesson.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of lesson.json.
inline constexpr std::string_view lessonFormatName = "echolucent-lesson";
inline constexpr const char* lessonFileName = "lesson.json";
/// Larger files, in bytes, are refused before they are read; images have largestLessonImage.
inline constexpr std::size_t largestLessonFile = std::size_t{1} << 20;
/// All files of a lesson together hold at most this many bytes.
inline constexpr std::size_t mostLessonBytes = std::size_t{32} << 20;
/// The most files of a lesson, and the most names in its folder that are looked at.
inline constexpr std::size_t mostLessonFiles = 100, mostLessonEntries = 1000;

/// The files of a lesson by name: "lesson.json", "en.md", "wall.png", "start.session.json".
struct LessonFiles {
    std::string folder;  ///< for messages
    std::map<std::string, std::string> bytes;
};

/// The files of a lesson in a folder: lesson.json, and names that end in .session.json, .md, .png, .jpg or .jpeg. Other
/// files and folders are left out. Fails (unreadable) if the folder cannot be read, or if a file is a link, is too
/// large, or is one too many.
[[nodiscard]] Result<LessonFiles> lessonFilesIn(const std::string& folder);
/// The lesson that these files hold. Fails (unreadable) with one sentence that names the file and the key: unknown and
/// missing keys, values out of range, conditions on names that nothing has, texts that miss a step.
[[nodiscard]] Result<Lesson> lessonFrom(const LessonFiles& files);
/// Both together.
[[nodiscard]] Result<Lesson> readLesson(const std::string& folder);

/// The files that lessonFrom() reads back. What steps set stands in lesson.json itself.
[[nodiscard]] LessonFiles filesOf(const Lesson& lesson);
/// Writes the files of a lesson into a folder, each whole or not at all. A folder that is not there yet appears whole
/// or not at all. Fails (unwritable) if it cannot be written, or if the lesson could not be read again. Other files in
/// the folder stay.
[[nodiscard]] Result<void> writeLesson(const std::string& folder, const Lesson& lesson);

}  // namespace echolucent
