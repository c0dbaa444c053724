// The difference of two pictures as a picture.
#pragma once

#include <QImage>

namespace echolucent {

struct DifferenceImage {
    QImage image;       ///< grey where both are alike, brighter where the first one is brighter
    double rmse = 0.0;  ///< over all pixels and colours, in levels of 255
};

/// The signed difference, first minus second, of each colour, times an amplification, around a grey of 128. Pictures
/// of different sizes, or without a pixel, have no difference: a null image and 0.
[[nodiscard]] DifferenceImage differenceOf(const QImage& first, const QImage& second, double amplification);

}  // namespace echolucent
