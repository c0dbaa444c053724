// Places, and planes through them, for the tests of planes and boxes.
#pragma once

#include "processing/scene/planes.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Between two places, mm.
inline double apart(const Vec3& a, const Vec3& b) { return length(a - b); }

/// Where the data lie, mm of the grid.
inline const DataBox dataOfPlaces{{-3, 5, 10}, {37, 35, 90}};

/// Planes that are turned, moved and cropped.
inline Planes unusualPlanes() {
    return {.direction = {33, -21, 70}, .offsetMm = {3, -2, 11}, .crops = {{{1, 2, 3}, {4, -5, 0.5}, {0, 0.25, 1}}}};
}

}  // namespace echolucent
