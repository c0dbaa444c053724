// The pieces of a stroke's line, as cutsAway() asks them. They stand in one place so that whoever asks only some of
// them gets the same bits.
#pragma once

#include "processing/picture/picture_place.h"

namespace echolucent::scalpel {

/// Whether a line from a to b is crossed on the way from a place to the left; an outline that is crossed an odd number
/// of times holds the place.
[[nodiscard]] bool crosses(const PicturePlace& a, const PicturePlace& b, const PicturePlace& at);

/// Whether a place lies within a distance of the line from a to b.
[[nodiscard]] bool liesWithin(double distance, const PicturePlace& a, const PicturePlace& b, const PicturePlace& at);

}  // namespace echolucent::scalpel
