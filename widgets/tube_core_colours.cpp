#include "widgets/tube_core_colours.h"

#include <algorithm>

namespace echolucent {

QColor tubeCoreColour(double share, const ThemeColours& colours) {
    return mixed(colours.lineStrong, colours.accent, std::clamp(share, 0.0, 1.0));
}

double tubeCoreWidth(double share) {
    constexpr double thinnest = 1.0, thickest = 2.5;
    return thinnest + (thickest - thinnest) * std::clamp(share, 0.0, 1.0);
}

}  // namespace echolucent
