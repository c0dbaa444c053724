// Who renders the volume.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace echolucent {

enum class RendererChoice {
    automatic,     ///< a wish only: the graphics card where there is a real one, else the software ray caster
    software,      ///< castRays(), on the processor
    graphicsCard,  ///< VTK's GPU mapper, through OpenGL, also where OpenGL is software
};

inline constexpr std::array<std::string_view, 3> rendererNames{"automatic", "software", "graphicsCard"};

/// "automatic", "software", "graphicsCard".
[[nodiscard]] inline std::string_view nameOf(RendererChoice renderer) {
    return rendererNames[static_cast<std::size_t>(renderer)];
}
[[nodiscard]] inline std::optional<RendererChoice> rendererFromName(std::string_view name) {
    for (std::size_t i = 0; i < rendererNames.size(); ++i)
        if (rendererNames[i] == name) return static_cast<RendererChoice>(i);
    return std::nullopt;
}

}  // namespace echolucent
