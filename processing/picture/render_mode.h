// What a picture shows of the samples on its rays.
#pragma once

#include <string_view>

namespace echolucent {

/// What a ray shows of its samples.
enum class RenderMode {
    direct,   ///< direct volume rendering: Petersch 2005, eqs. 2 and 3
    maximum,  ///< the colour of the largest intensity on the ray; this mode and those below ignore the curve
    minimum,  ///< the colour of the smallest intensity on the ray
    mean,     ///< the colour of the mean intensity on the ray: an x-ray
};

/// "direct", "maximum", "minimum", "mean".
[[nodiscard]] std::string_view nameOf(RenderMode mode);

}  // namespace echolucent
