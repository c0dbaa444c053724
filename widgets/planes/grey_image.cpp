#include "widgets/planes/grey_image.h"

namespace echolucent {

QImage greyImage(const PlaneSamples& samples, const GreyScale& scale) {
    QImage image(samples.columns, samples.rows, QImage::Format_Grayscale8);
    const auto slope = static_cast<float>(255.0 * scale.brightness / scale.window);
    const auto offset = static_cast<float>(255.0 * scale.brightness * (0.5 - scale.level / scale.window)) + 0.5f;
    for (int row = 0; row < samples.rows; ++row) {
        const float* from =
            samples.intensity.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(samples.columns);
        uchar* to = image.scanLine(row);
        for (int column = 0; column < samples.columns; ++column) {
            const float grey = from[column] * slope + offset;
            // No data is NaN, for which every comparison is false.
            to[column] = static_cast<uchar>(grey >= 0.0f ? (grey < 255.0f ? grey : 255.0f) : 0.0f);
        }
    }
    return image;
}

}  // namespace echolucent
