// From a place of the volume to its place in a picture, and back.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "processing/picture/camera.h"

namespace echolucent {

/// A place in a picture: right and down of its centre, in picture heights.
using PicturePlace = std::array<double, 2>;

/// Where a camera sees a place of the grid, mm. Empty in perspective if the place is not before the eye.
[[nodiscard]] std::optional<PicturePlace> placeInPicture(const Camera& camera, const Vec3& gridMm);

/// The place of the grid, mm, that a camera sees at a place of the picture and a depth. The depth is mm along
/// camera.frame.forward from the grid origin. In perspective it must lie before the eye.
[[nodiscard]] Vec3 gridPlaceAt(const Camera& camera, const PicturePlace& place, double depthMm);

/// What is wrong with a camera read from a file, lower case, no full stop. Empty if nothing is wrong.
[[nodiscard]] std::string problemOf(const Camera& camera);

}  // namespace echolucent
