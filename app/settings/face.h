// The window's two faces.
#pragma once

#include <optional>
#include <string_view>

#include "processing/choice_names.h"

namespace echolucent {

/// Review looks at a scan with sliders and presets. Teach shows all that there is, to show what the choice of an OTF
/// does. A face is no part of the document, and keys mean the same in both.
enum class Face { review, teach };

inline constexpr ChoiceNames<2> faceNames{"review", "teach"};

/// "review", "teach".
[[nodiscard]] inline std::string_view nameOf(Face face) { return nameIn(faceNames, face); }
[[nodiscard]] inline std::optional<Face> faceFromName(std::string_view name) {
    return choiceNamed<Face>(faceNames, name);
}

}  // namespace echolucent
