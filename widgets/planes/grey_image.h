// Grey values of a plane as an image.
#pragma once

#include <QImage>

#include "processing/sampling/plane_sampling.h"

namespace echolucent {

/// How intensities become grey. `level` is half bright, and `window` (> 0) reaches from black to white. `brightness` (>
/// 0) then multiplies the grey.
struct GreyScale {
    double window = 1.0, level = 0.5, brightness = 1.0;
    friend bool operator==(const GreyScale&, const GreyScale&) = default;
};

/// Eight bits a pixel, row by row from the top. No data is black.
[[nodiscard]] QImage greyImage(const PlaneSamples& samples, const GreyScale& scale);

}  // namespace echolucent
