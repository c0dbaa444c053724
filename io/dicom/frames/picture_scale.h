// The size of the pixels of a data set's pictures.
#pragma once

#include <optional>
#include <string>

#include "processing/volume/geometry.h"

class DcmItem;

namespace echolucent {

struct PictureScale {
    Vec3 spacing{1, 1, 1};  ///< mm; along x and y as stated, along z their mean: a guess
    std::string source;     ///< the tags of x and y
};

/// The scale that Pixel Spacing states. Else the scale of the largest 2D ultrasound region; M-modes and spectra do not
/// count; a region that states no format counts as 2D. The region's deltas must be in cm, and its pixels from 0.0001 mm
/// to 10 m large. No value if nothing states a scale.
[[nodiscard]] std::optional<PictureScale> pictureScaleOf(DcmItem& dataset);

}  // namespace echolucent
