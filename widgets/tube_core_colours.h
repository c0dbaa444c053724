// How tube cores are told apart by their weight, wherever they are drawn: the heavier, the more of the accent and the
// thicker.
#pragma once

#include <QColor>

#include "widgets/theme_colours.h"

namespace echolucent {

/// The colour of a tube core with a share in [0,1] of the largest weight; without a weight it has the colour at 0.
[[nodiscard]] QColor tubeCoreColour(double share, const ThemeColours& colours);

/// The width of its lines, pixels of a plain screen.
[[nodiscard]] double tubeCoreWidth(double share);

}  // namespace echolucent
