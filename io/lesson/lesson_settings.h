// What the steps of a lesson set, as paths and values for a person.
#pragma once

#include <string>
#include <vector>

#include "processing/lesson/lesson.h"

namespace echolucent {

/// A value of the document that a step sets.
struct LessonSetting {
    std::string path;   ///< docs/document.md#paths
    std::string value;  ///< "linear", "12.5", "[0,0,1]"; of long lists the number of their entries
    friend bool operator==(const LessonSetting&, const LessonSetting&) = default;
};

/// By step: what differs from the step before once that was solved; of the first step, from the program's defaults. Of
/// a list all entries are named, without what they do not have. A step that sets nothing has none.
[[nodiscard]] std::vector<std::vector<LessonSetting>> settingsOf(const Lesson& lesson);

}  // namespace echolucent
