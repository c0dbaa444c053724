// Single values of a document as the JSON that a document has of them, in one line: what settings remember.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/document/method_choice.h"
#include "processing/motion/motion_choice.h"
#include "processing/picture/look.h"

namespace echolucent {

[[nodiscard]] std::string textOf(const Look& look);
[[nodiscard]] std::string textOf(const MethodChoice& method);
[[nodiscard]] std::string textOf(const MotionChoice& motion);

/// The value that textOf() wrote; no value if the text is none, or if something in it is missing or out of range. Rows
/// of the tables that are missing have their defaults.
[[nodiscard]] std::optional<Look> lookFromText(std::string_view text);
[[nodiscard]] std::optional<MethodChoice> methodFromText(std::string_view text);
[[nodiscard]] std::optional<MotionChoice> motionFromText(std::string_view text);

}  // namespace echolucent
