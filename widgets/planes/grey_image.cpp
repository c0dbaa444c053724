#include "widgets/planes/grey_image.h"

#include <algorithm>

namespace echolucent {

QImage greyImage(const PlaneSamples& samples, const GreyScale& scale) {
    QImage image(samples.columns, samples.rows, QImage::Format_Grayscale8);
    const auto slope = static_cast<float>(255.0 * scale.brightness / scale.window);
    const auto offset = static_cast<float>(255.0 * scale.brightness * (0.5 - scale.level / scale.window)) + 0.5f;
    const int columns = samples.columns;
    for (int row = 0; row < samples.rows; ++row) {
        const float* from =
            samples.intensity.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
        uchar* to = image.scanLine(row);
        for (int column = 0; column < columns; ++column) {
            // No data is NaN. Every comparison with it is false, so max() returns its first argument. Without a branch,
            // and with a conversion that processors have, the loop takes many pixels at once.
            const float grey = std::min(std::max(0.0f, from[column] * slope + offset), 255.0f);
            to[column] = static_cast<uchar>(static_cast<int>(grey));
        }
    }
    return image;
}

}  // namespace echolucent
