// Grey values of a plane as an image.
#pragma once

#include <QImage>

#include "processing/sampling/plane_sampling.h"

namespace echolucent {

/// How intensities become grey: `level` is half bright, `window` reaches from black to white (> 0), and grey is
/// multiplied by `brightness` (> 0) then.
struct GreyScale {
    double window = 1.0, level = 0.5, brightness = 1.0;
    friend bool operator==(const GreyScale&, const GreyScale&) = default;
};

/// Eight bits a pixel, row by row from the top; black where there is no data.
[[nodiscard]] QImage greyImage(const PlaneSamples& samples, const GreyScale& scale);

}  // namespace echolucent
