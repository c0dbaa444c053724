// The colours of plots: of the curve editor, of the OTF over the angle.
#pragma once

#include "widgets/theme_colours.h"

namespace echolucent {

struct PlotColours {
    QColor background, text, secondary, grid, frame, histogram, histogramOutline;
};
/// Of a plot whose ground lies a little deeper than its panel in the dark theme, and is white in the light one.
[[nodiscard]] PlotColours plotColours(Theme theme);

}  // namespace echolucent
