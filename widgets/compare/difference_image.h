// The difference of two pictures as a picture.
#pragma once

#include <QImage>

namespace echolucent {

struct DifferenceImage {
    QImage image;       ///< grey if both are alike, brighter if the first one is brighter
    double rmse = 0.0;  ///< over all pixels and colours, in levels of 255
};

/// The signed difference of each colour, first minus second, times an amplification, around a grey of 128. Pictures of
/// different sizes, or without pixels, give a null image and 0.
[[nodiscard]] DifferenceImage differenceOf(const QImage& first, const QImage& second, double amplification);

}  // namespace echolucent
