#include "processing/picture/render_mode.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<4> renderModeNames{"direct", "maximum", "minimum", "mean"};
}

std::string_view nameOf(RenderMode mode) { return nameIn(renderModeNames, mode); }

}  // namespace echolucent
