// The lights of a picture, by the names that a person chooses from.
#pragma once

#include <optional>
#include <string_view>

namespace echolucent {

/// What light does in a picture; it plays a part in direct mode only.
enum class Lighting {
    flat,     ///< no light: a sample shows the colour of its intensity
    surface,  ///< light falls on surfaces
    depth,    ///< light falls on surfaces, weakened by the tissue before them
};

/// "flat", "surface", "depth".
[[nodiscard]] std::string_view nameOf(Lighting lighting);

}  // namespace echolucent
