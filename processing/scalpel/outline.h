// How cutsAway() tests the pieces of a stroke's line. A caller that tests only some pieces calls the same functions, so
// that it gets the same bits.
#pragma once

#include "processing/picture/picture_place.h"

namespace echolucent::scalpel {

/// Whether the line from a to b crosses the way from a place to the right. An outline with an odd number of crossings
/// holds the place.
[[nodiscard]] bool crosses(const PicturePlace& a, const PicturePlace& b, const PicturePlace& at);

/// Whether a place lies within a distance of the line from a to b.
[[nodiscard]] bool liesWithin(double distance, const PicturePlace& a, const PicturePlace& b, const PicturePlace& at);

}  // namespace echolucent::scalpel
