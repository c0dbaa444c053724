// How far a picture is from a reference, for reports of error against run time.
#pragma once

#include "processing/picture/picture.h"

namespace echolucent {

/// The difference over red, green and blue on a black background, from floats in [0,1].
struct PictureDifference {
    double rms = 0.0;      ///< root of the mean squared difference over pixels and colours
    double largest = 0.0;  ///< largest absolute difference
};

/// Throws std::invalid_argument if the sizes differ.
[[nodiscard]] PictureDifference differenceOf(const Picture& picture, const Picture& reference);

/// PictureDifference in levels of 8 bits (255 is white), with the structural similarity.
struct PictureError {
    double rmse = 0.0;     ///< root of the mean squared difference over pixels and colours
    double largest = 0.0;  ///< largest absolute difference
    /// Mean structural similarity of luminance (0.2126, 0.7152, 0.0722), 1: equal. Wang et al. 2004: Gaussian window of
    /// 11 x 11 pixels and sigma 1.5, K1 = 0.01, K2 = 0.03, L = 255. The mean is over windows inside the picture. If the
    /// picture is smaller than a window, it is over all, with the picture mirrored at its edges.
    double ssim = 1.0;
};

/// Throws std::invalid_argument if the sizes differ.
[[nodiscard]] PictureError pictureError(const Picture& picture, const Picture& reference);

/// 0.5 + amplification * (picture - reference), clamped into [0,1], opaque: grey if they are equal. Throws
/// std::invalid_argument if the sizes differ.
[[nodiscard]] Picture signedDifference(const Picture& picture, const Picture& reference, double amplification);

}  // namespace echolucent
