// A whole lesson as one HTML page: for a class that reads it on paper, or without the program.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "processing/lesson/lesson.h"
#include "processing/picture/picture.h"
#include "processing/progress.h"

namespace echolucent {

/// The pictures of a step with their captions: one of each pane.
using LessonPictures = std::vector<std::pair<Picture, std::string>>;

/// By step: what its document shows as the step begins, at most 480 pixels wide. A step that shows what the one before
/// showed has none. The lesson's scan is simulated for it. Empty if progress.cancel was raised.
[[nodiscard]] std::optional<std::vector<LessonPictures>> lessonPictures(const Lesson& lesson,
                                                                        const Progress& progress = {});

struct LessonHandout {
    std::string language;  ///< as textIn() takes it
    std::string program;   ///< name and version
    std::vector<LessonPictures> pictures{};
};

/// The file. It needs no other one and no network. Title, summary and the steps with their pictures, texts, hints and
/// questions; behind them the right answers with their explanations, and what each step sets.
[[nodiscard]] std::string lessonHandout(const Lesson& lesson, const LessonHandout& handout);

}  // namespace echolucent
