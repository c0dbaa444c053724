// Who renders the volume.
#pragma once

#include <optional>
#include <string_view>

#include "processing/choice_names.h"

namespace echolucent {

enum class RendererChoice {
    automatic,     ///< the graphics card if a real one can draw the volume, else the software
    software,      ///< castRays(), on the processor
    graphicsCard,  ///< the same rays through OpenGL, even if OpenGL is software
};

inline constexpr ChoiceNames<3> rendererNames{"automatic", "software", "graphicsCard"};

/// "automatic", "software", "graphicsCard".
[[nodiscard]] inline std::string_view nameOf(RendererChoice renderer) { return nameIn(rendererNames, renderer); }
[[nodiscard]] inline std::optional<RendererChoice> rendererFromName(std::string_view name) {
    return choiceNamed<RendererChoice>(rendererNames, name);
}

}  // namespace echolucent
