// Which lights a picture has, by the name that a person chooses.
#pragma once

#include <optional>
#include <string_view>

namespace echolucent {

/// What light does in a picture; it plays a part in direct mode only.
enum class Lighting {
    flat,     ///< none: a sample shows the colour of its intensity
    surface,  ///< light falls on surfaces
    depth,    ///< light falls on surfaces, and only as much of it as reaches them through the tissue before them
};

/// "flat", "surface", "depth".
[[nodiscard]] std::string_view nameOf(Lighting lighting);
[[nodiscard]] std::optional<Lighting> lightingFromName(std::string_view name);

}  // namespace echolucent
