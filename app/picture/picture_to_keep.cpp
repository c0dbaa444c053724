#include "app/picture/picture_to_keep.h"

#include <QPainter>

#include "processing/document/shown_measurement.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

QImage pictureToKeep(VolumeViewWidget& picture, const Document& document, int view, const VolumeGeometry& geometry) {
    QImage image = picture.convergedImage();
    const auto shown = shownMeasurements(document.measurements, phaseOf(document, view), geometry);
    if (image.isNull() || shown.empty()) return image;
    QPainter painter(&image);
    paintMeasurements(painter, placedInPicture(shown, picture.shownCamera()), image.size(),
                      picture.devicePixelRatioF());
    return image;
}

}  // namespace echolucent
