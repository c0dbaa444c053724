// Finds what lies under the cursor.
#pragma once

#include <optional>

#include "processing/picture/picture_request.h"

namespace echolucent {

/// The sample of a ray that a person sees.
struct PointedSample {
    double intensity = 0.0;  ///< normalised
    double opacity = 0.0;    ///< per unit
    Vec3 gridMm{0, 0, 0};
};

/// Follows the ray of the pixel at a point of the picture (pixels from the top left corner; pixel centres at halves)
/// with the steps that castRays() takes there. Returns the sample at which the accumulated opacity reaches one half. If
/// the opacity never reaches it, returns the sample that contributes most. In modes without a curve it is the largest
/// or the smallest sample. In the mean it is the mean, at the place of the first sample. The result is empty without a
/// volume, beside the picture, and if the ray meets nothing visible. It takes one ray's time, well below a millisecond.
/// The settings must be those of the picture on the screen.
[[nodiscard]] std::optional<PointedSample> samplePointedAt(const PaneRequest& pane, const RayCastSettings& settings,
                                                           double x, double y);

/// The normalised intensity at a place, trilinear; empty if there is no data.
[[nodiscard]] std::optional<double> measuredAt(const Volume& volume, const Vec3& gridMm);

}  // namespace echolucent
