// Single values of a document as its JSON writes them, in one line. The settings remember these.
#pragma once

#include <string>
#include <string_view>

#include "processing/document/method_choice.h"
#include "processing/motion/motion_choice.h"
#include "processing/picture/look.h"

namespace echolucent {

[[nodiscard]] std::string textOf(const Look& look);
[[nodiscard]] std::string textOf(const MethodChoice& method);
[[nodiscard]] std::string textOf(const MotionChoice& motion);

/// The value that textOf() wrote. Each row that is missing, of another kind or out of range has its default; the others
/// count. A method has the default config if its rows contradict each other. Tube cores that are never placed belong to
/// the study and are not read.
[[nodiscard]] Look lookFromText(std::string_view text);
[[nodiscard]] MethodChoice methodFromText(std::string_view text);
[[nodiscard]] MotionChoice motionFromText(std::string_view text);

}  // namespace echolucent
