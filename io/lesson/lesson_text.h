// A lesson's texts as Markdown: which words belong to which step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/lesson/lesson.h"
#include "processing/lesson/lesson_draft.h"
#include "processing/result.h"

namespace echolucent {

/// The texts of a file "LANGUAGE.md" for steps of these ids, in this order. A line "# TITLE" begins the summary, "##
/// TITLE {#ID}" a step, and within a step "### … {#hint}", "### … {#question}" (whose list items are the answers) and
/// "### …
/// {#explanation}". Fails (unreadable) if a step has no section, if a section belongs to no step or stands there twice,
/// and if an image is none of `images`. Lengths are checked by problemOf(Lesson).
[[nodiscard]] Result<LessonText> lessonTextFrom(const std::string& markdown, const std::string& language,
                                                const std::vector<std::string>& ids,
                                                const std::vector<std::string>& images, const std::string& file);
/// The Markdown that lessonTextFrom() reads back.
[[nodiscard]] std::string markdownOf(const LessonText& text, const std::vector<std::string>& ids);

/// The names in the images of a Markdown text ("![words](NAME)", "![words](NAME 'title')" and "![words]: NAME"), as
/// they stand there. Empty for an image that has no name there, or whose words are more than words.
[[nodiscard]] std::vector<std::string> imagesIn(const std::string& markdown);

/// The texts of a lesson that markdownOf() writes and lessonTextFrom() would not give back as they are.
[[nodiscard]] std::vector<LessonProblem> problemsOfMarkdown(const Lesson& lesson);

}  // namespace echolucent
