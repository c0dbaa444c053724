// The JSON of a lesson's steps, in files of lessons and of drafts.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "processing/lesson/lesson.h"

namespace echolucent {

/// lesson.json of a lesson, which may break rules but for that of its study, a simulated scan.
[[nodiscard]] nlohmann::ordered_json lessonJson(const Lesson& lesson);
/// The value of a condition that is a number, a text, true, false or null. False if the JSON is none of them.
[[nodiscard]] bool takeValue(const nlohmann::json& value, DocumentValue& taken);

}  // namespace echolucent
