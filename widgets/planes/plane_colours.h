// What is drawn over pictures, which are on black in every theme: the one colour of each plane, in frames, lines and
// letters, and the colours of the render box.
#pragma once

#include <QColor>

#include "processing/document/planes.h"
#include "widgets/theme_colours.h"

namespace echolucent {

[[nodiscard]] inline QColor colourOf(PlaneName plane) {
    switch (plane) {
        case PlaneName::a: return {0xe0, 0x6c, 0x75};
        case PlaneName::b: return {0x98, 0xc3, 0x79};
        case PlaneName::c: return {0x61, 0xaf, 0xef};
    }
    return {};
}

/// Amber, and the accent for the side through which the box is looked into.
[[nodiscard]] inline QColor boxColour() { return coloursOverPictures().warning; }
[[nodiscard]] inline QColor boxFrontColour() { return coloursOverPictures().accent; }
/// Of edges that the box itself hides.
[[nodiscard]] inline QColor boxBehindColour() { return {0x8a, 0x6c, 0x38}; }

}  // namespace echolucent
