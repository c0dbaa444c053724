// What a person wants the picture to be rendered by.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace echolucent {

enum class PreferredRenderer {
    automatic,  ///< the graphics card where there is a real one, else the software
    software,
    graphicsCard,
};

inline constexpr std::array<std::string_view, 3> preferredRendererNames{"automatic", "software", "graphicsCard"};

/// "automatic", "software", "graphicsCard".
[[nodiscard]] inline std::string_view nameOf(PreferredRenderer renderer) {
    return preferredRendererNames[static_cast<std::size_t>(renderer)];
}
[[nodiscard]] inline std::optional<PreferredRenderer> preferredRendererFromName(std::string_view name) {
    for (std::size_t i = 0; i < preferredRendererNames.size(); ++i)
        if (preferredRendererNames[i] == name) return static_cast<PreferredRenderer>(i);
    return std::nullopt;
}

}  // namespace echolucent
