#include "app/picture/panes_picture.h"

#include <QPainter>

#include "app/picture/picture_caption.h"
#include "processing/picture/picture.h"
#include "processing/scene/shown_measurement.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/picture_labels/picture_labels.h"

namespace echolucent {

namespace {

std::optional<QImage> pictureOf3d(const PanesInPicture& panes, const Progress& progress) {
    const QSize size = panes.of3d->size();
    const Document& document = panes.document;
    const auto picture = PaneCaster(panes.phases).picture(document, firstPane, size.width(), size.height(), progress);
    if (!picture) return std::nullopt;
    const std::vector<std::uint8_t> rgb = overBackground(picture->picture, Vec3(0, 0, 0));
    QImage image =
        QImage(rgb.data(), size.width(), size.height(), qsizetype{3} * size.width(), QImage::Format_RGB888).copy();
    QPainter painter(&image);
    const Volume& voxels = *picture->voxels;
    const auto measured = shownMeasurementsIn3d(document.measurements, phaseOf(document, firstPane), voxels,
                                                document.scene.planes, document.beam.axis);
    paintMeasurements(painter, placedInPicture(measured, picture->cast.camera), size, panes.scale);
    const bool known = voxels.geometry().spacingKnown;
    const QString caption =
        pictureCaption({.document = document,
                        .speckle = ShownSpeckle::reduced,
                        .curveOfAnotherView = curveIsOfAnotherView(document, otfViewpointOf(document, firstPane)),
                        .sides = panes.sides.get(),
                        .lengthsKnown = known,
                        .reduction = voxels.geometry().reduction});
    paintLabels(painter, size, {.caption = caption, .camera = picture->cast.camera, .spacingKnown = known},
                panes.scale);
    return image;
}

}  // namespace

std::optional<QImage> panesPicture(const PanesInPicture& panes, const Progress& progress) {
    QImage image(panes.size, QImage::Format_RGB888);
    image.fill(Qt::black);
    QPainter painter(&image);
    for (const PlaneInPicture& plane : panes.planes) {
        if (progress.cancelled()) return std::nullopt;
        const PlaneSamples samples = sampledPlane(*plane.request.volume, gridOf(plane.request));
        painter.drawImage(plane.place, greyImage(samples, plane.greys));
        painter.drawImage(plane.place, plane.drawings);
    }
    if (!panes.of3d) return image;
    const std::optional<QImage> of3d = pictureOf3d(panes, progress);
    if (!of3d) return std::nullopt;
    painter.drawImage(*panes.of3d, *of3d);
    return image;
}

}  // namespace echolucent
