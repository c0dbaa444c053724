// The one colour of each plane, in frames, lines and letters.
#pragma once

#include <QColor>

#include "processing/document/planes.h"

namespace echolucent {

[[nodiscard]] inline QColor colourOf(PlaneName plane) {
    switch (plane) {
        case PlaneName::a: return {0xe0, 0x6c, 0x75};
        case PlaneName::b: return {0x98, 0xc3, 0x79};
        case PlaneName::c: return {0x61, 0xaf, 0xef};
    }
    return {};
}

}  // namespace echolucent
