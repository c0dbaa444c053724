#include "app/picture/labelled_picture.h"

#include <QPainter>
#include <new>

#include "app/picture/picture_caption.h"
#include "processing/scene/shown_measurement.h"
#include "widgets/casting/picture_image.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/picture_labels/picture_labels.h"

namespace echolucent {

QImage labelledPicture(const PanePicture& picture, const Document& shown, const LabelFacts& facts, double scale) {
    QImage image = imageOf(picture.picture);
    if (image.isNull()) throw std::bad_alloc();
    const VolumeGeometry& geometry = picture.voxels->geometry();
    const QString caption = pictureCaption({.document = shown,
                                            .speckle = ShownSpeckle::reduced,
                                            .curveOfAnotherView = facts.curveOfAnotherView,
                                            .curveIsTold = facts.curveIsTold,
                                            .sides = facts.sides,
                                            .remembered = facts.remembered,
                                            .lengthsKnown = geometry.spacingKnown,
                                            .reduction = geometry.reduction});
    const auto measured = shownMeasurementsIn3d(shown.measurements, phaseOf(shown, firstPane), *picture.voxels,
                                                shown.scene.planes, shown.beam.axis);
    QPainter painter(&image);
    paintMeasurements(painter, placedInPicture(measured, picture.cast.camera), image.size(), scale);
    paintLabels(painter, image.size(),
                {.caption = caption,
                 .frame = facts.frame,
                 .camera = picture.cast.camera,
                 .spacingKnown = geometry.spacingKnown},
                scale);
    return image;
}

}  // namespace echolucent
