#include "app/picture/panes_picture.h"

#include <QFontInfo>
#include <QPainter>
#include <algorithm>
#include <new>

#include "app/picture/labelled_picture.h"
#include "app/picture/picture_caption.h"
#include "widgets/casting/picture_image.h"

namespace echolucent {

namespace {

std::optional<QImage> pictureOf3d(const PanesInPicture& panes, const Progress& progress) {
    const QSize size = panes.of3d->size();
    const Document& document = panes.document;
    const auto picture = PaneCaster(panes.phases).picture(document, firstPane, size.width(), size.height(), progress);
    if (!picture) return std::nullopt;
    return labelledPicture(*picture, document,
                           {.curveOfAnotherView = curveIsOfAnotherView(document, otfViewpointOf(document, firstPane)),
                            .curveIsTold = panes.curveIsTold,
                            .sides = panes.sides.get(),
                            .remembered = panes.remembered},
                           panes.scale * panes.words);
}

/// Paints the compared panes. False if the work was cancelled.
bool paintCompared(QPainter& painter, const PanesInPicture& panes, const Progress& progress) {
    if (panes.compared.empty()) return true;
    QStringList names;
    for (const ComparedInPicture& compared : panes.compared) names << compared.face.name;
    QFont letters = panes.letters;
    letters.setPixelSize(std::max(1, qRound(QFontInfo(letters).pixelSize() * panes.scale * panes.words)));
    const CaptionLayout caption = captionLayout(names, panes.compared.front().place.width(), letters);
    PaneCaster caster(panes.phases);
    for (const ComparedInPicture& compared : panes.compared) {
        const QRect place = pictureIn(compared.place, caption);
        if (place.isEmpty()) continue;
        const auto picture = caster.pictureOf(compared.classification, panes.document, compared.pane, place.width(),
                                              place.height(), {{}, progress.cancel});
        if (!picture) return false;
        painter.drawImage(place, imageOf(picture->picture));
        paintFace(painter, compared.place, compared.face, caption);
    }
    return true;
}

}  // namespace

std::optional<QImage> panesPicture(const PanesInPicture& panes, const Progress& progress) {
    QImage image(panes.size, QImage::Format_RGB888);
    if (image.isNull()) throw std::bad_alloc();
    image.fill(Qt::black);
    QPainter painter(&image);
    for (const PlaneInPicture& plane : panes.planes) {
        if (progress.cancelled()) return std::nullopt;
        if (plane.drawings.isNull()) throw std::bad_alloc();
        const PlaneSamples samples = sampledPlane(*plane.request.volume, gridOf(plane.request));
        painter.drawImage(plane.place, greyImage(samples, plane.greys));
        painter.drawImage(plane.place, plane.drawings);
    }
    if (!paintCompared(painter, panes, progress)) return std::nullopt;
    if (!panes.of3d) return image;
    const std::optional<QImage> of3d = pictureOf3d(panes, progress);
    if (!of3d) return std::nullopt;
    painter.drawImage(*panes.of3d, *of3d);
    return image;
}

}  // namespace echolucent
