// The place from which a picture looks at a volume, and its projection.
#pragma once

#include <optional>
#include <string_view>

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

enum class Projection { parallel, perspective };

/// "parallel", "perspective".
[[nodiscard]] std::string_view nameOf(Projection projection);
[[nodiscard]] std::optional<Projection> projectionFromName(std::string_view name);

/// A camera in grid mm.
struct Camera {
    Vec3 focalPoint{0, 0, 0};  ///< seen at the picture's centre
    ViewFrame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Projection projection = Projection::parallel;
    double heightMm = 1.0;           ///< parallel: height of the picture, mm
    double viewAngleDegrees = 30.0;  ///< perspective: full vertical angle
    double distanceMm = 1.0;         ///< perspective: from the eye to the focal point
    friend bool operator==(const Camera& a, const Camera& b) = default;
};

/// The camera of the default picture: parallel, along the view, for a picture of this width / height (> 0). It fits the
/// view's box, or the data box if the view has none. The box is centred and whole in the picture, with 4 % of its
/// extent to spare. The perspective values are set too, so a change of projection keeps the box in the picture. Throws
/// std::invalid_argument if `aspect` is not above 0 or not finite.
[[nodiscard]] Camera defaultCamera(const DataBox& box, const Viewpoint& view, double aspect);

}  // namespace echolucent
