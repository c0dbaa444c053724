// The colours of plots: of the curve editor, and of the OTF over the angle.
#pragma once

#include "widgets/theme_colours.h"

namespace echolucent {

struct PlotColours {
    QColor background, text, secondary, grid, frame, histogram, histogramOutline;
};
/// In the dark theme the ground of a plot is a little darker than its panel; in the light theme it is white.
[[nodiscard]] PlotColours plotColours(Theme theme);

}  // namespace echolucent
