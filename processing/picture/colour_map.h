// Colours of intensities.
#pragma once

#include <string_view>

#include "processing/volume/geometry.h"

namespace echolucent {

enum class ColourMap { sepia, grey, ice };

/// "sepia", "grey", "ice".
[[nodiscard]] std::string_view nameOf(ColourMap map);
/// Colour of a normalised intensity, each component in [0,1]. A fully opaque, unshaded voxel shows this colour.
[[nodiscard]] Vec3 colourOf(ColourMap map, double intensity);

/// The tint of a shadow (t of Shading): bright tissue in shadow takes the map's dark hue, not grey.
[[nodiscard]] Vec3 shadowTintOf(ColourMap map);

}  // namespace echolucent
