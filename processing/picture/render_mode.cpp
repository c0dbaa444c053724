#include "processing/picture/render_mode.h"

#include <algorithm>
#include <array>

namespace echolucent {

namespace {
constexpr std::array<std::string_view, 4> renderModeNames{"direct", "maximum", "minimum", "mean"};
}

std::string_view nameOf(RenderMode mode) { return renderModeNames[static_cast<std::size_t>(mode)]; }

std::optional<RenderMode> renderModeFromName(std::string_view name) {
    const auto* found = std::find(renderModeNames.begin(), renderModeNames.end(), name);
    if (found == renderModeNames.end()) return std::nullopt;
    return static_cast<RenderMode>(found - renderModeNames.begin());
}

}  // namespace echolucent
