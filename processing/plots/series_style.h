// Tells the series of a plot apart, in print, on light and on dark ground.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "processing/plots/plot.h"

namespace echolucent {

/// The colours of the editor's curves. On light ground a plot takes the darker ones. Their contrast with white is at
/// least 4.5 : 1.
struct SeriesColour {
    std::string_view curve;  ///< the opacity curve with this colour; empty if it is no curve's own
    std::string_view onLight, onDark;
    std::string_view dashes;  ///< SVG's stroke-dasharray; empty for a solid line
};
inline constexpr std::array<SeriesColour, 8> seriesColours{{{"adaptive", "#1c7f8c", "#4fb3bf", ""},
                                                            {"manual", "#966400", "#e8b04b", ""},
                                                            {"linear", "#66717d", "#9aa5b1", "7 4"},
                                                            {"parabolic", "#905a8a", "#b48ead", "2 3"},
                                                            {"quartic", "#3c7f3c", "#8fbc8f", "8 3 2 3"},
                                                            {"", "#b83f4b", "#e07a83", ""},
                                                            {"", "#2f66b5", "#81a9e0", "10 3"},
                                                            {"", "#a04e26", "#e39a78", "4 2"}}};

/// The colour of faint series.
inline constexpr SeriesColour faintColour{"", "#9aa1a9", "#626c77", ""};
/// The colour of an index of coloursOf().
[[nodiscard]] constexpr const SeriesColour& colourAt(std::size_t index) {
    return index < seriesColours.size() ? seriesColours[index] : faintColour;
}

/// For each series the index of its colour; seriesColours.size() for a faint one. If the series' name begins with a
/// curve's name, it is the curve's own colour, else the next free one. A series that has a
/// colour (PlotSeries::colour) keeps it. Beyond the eighth series the colours repeat.
[[nodiscard]] std::vector<std::size_t> coloursOf(const std::vector<PlotSeries>& series);

}  // namespace echolucent
