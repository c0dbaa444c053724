#include "app/picture/picture_to_keep.h"

#include <QPainter>

#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

std::vector<ShownMeasurement> measurementsIn(const VolumeViewWidget& picture, const OpenStudy& openStudy,
                                             const Document& document) {
    const auto& measured = picture.measured();
    const auto phase = measured ? openStudy.phaseOfVoxels(*measured) : std::nullopt;
    if (!phase) return {};
    return shownMeasurementsIn3d(document.measurements, *phase, *measured, document.scene.planes, document.beam.axis);
}

QImage pictureToKeep(VolumeViewWidget& picture, const OpenStudy& openStudy, const Document& document) {
    QImage image = picture.convergedImage();
    const auto shown = measurementsIn(picture, openStudy, document);
    if (image.isNull() || shown.empty()) return image;
    QPainter painter(&image);
    paintMeasurements(painter, placedInPicture(shown, picture.shownCamera()), image.size(),
                      picture.devicePixelRatioF());
    return image;
}

}  // namespace echolucent
