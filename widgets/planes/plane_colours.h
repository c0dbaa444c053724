// Colours over pictures, which are on black in every theme: one colour for each plane, in frames, lines and letters,
// and the colours of render box and front.
#pragma once

#include <QColor>

#include "processing/scene/planes.h"
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

/// The box is amber, the front has the accent.
[[nodiscard]] inline QColor boxColour() { return coloursOverPictures().warning; }
[[nodiscard]] inline QColor frontColour() { return coloursOverPictures().accent; }
/// The colour of edges hidden behind the box itself.
[[nodiscard]] inline QColor boxBehindColour() { return {0x8a, 0x6c, 0x38}; }

}  // namespace echolucent
