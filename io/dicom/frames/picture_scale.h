// How large the pixels of a data set's pictures are.
#pragma once

#include <optional>
#include <string>

#include "processing/volume/geometry.h"

class DcmItem;

namespace echolucent {

/// The scale of a picture.
struct PictureScale {
    Vec3 spacing{1, 1, 1};  ///< mm; along x and y as stated, along z their mean: a guess
    std::string source;     ///< the tags that gave x and y
};

/// The scale that Pixel Spacing states, else the largest 2D region of the ultrasound regions (of M-modes and spectra
/// none) whose deltas count in cm and make pixels that a scanner may have; no value where nothing states it.
[[nodiscard]] std::optional<PictureScale> pictureScaleOf(DcmItem& dataset);

}  // namespace echolucent
