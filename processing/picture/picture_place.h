// Where a place of the volume is seen in a picture, and what lies behind a place of the picture.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "processing/picture/camera.h"

namespace echolucent {

/// A place in a picture: right and down of its centre, in picture heights.
using PicturePlace = std::array<double, 2>;

/// Where a camera sees a place of the grid, mm; nothing in perspective for what does not lie before the eye.
[[nodiscard]] std::optional<PicturePlace> placeInPicture(const Camera& camera, const Vec3& gridMm);

/// The place of the grid, mm, that a camera sees there at a depth: mm along camera.frame.forward from the grid origin.
/// In perspective the depth must lie before the eye.
[[nodiscard]] Vec3 gridPlaceAt(const Camera& camera, const PicturePlace& place, double depthMm);

/// What is wrong with a camera that was read from a file, lower case, no full stop; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const Camera& camera);

}  // namespace echolucent
