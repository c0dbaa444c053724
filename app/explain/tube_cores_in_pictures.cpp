#include "app/explain/tube_cores_in_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/explain/tube_core_overlay.h"
#include "app/planes/box_in_3d.h"
#include "processing/picture/picture_place.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

/// A mark in the 3D view is hit within this distance, logical pixels: targets are 18 pixels wide.
constexpr double reachIn3d = 9.0;

}  // namespace

TubeCoresInPictures::TubeCoresInPictures(Parts parts, QObject* parent) : QObject(parent), m_parts(std::move(parts)) {
    for (PlanePane* pane : m_parts.planes) {
        auto* pointer = new MarkingPointer(
            *pane,
            [this, pane](const QPointF& at) {
                const bool hit = m_marks && pane->scene() && m_parts.handIsFree() &&
                                 tubeCoreAt(pane->tubeCores(), pane->mapping(), at);
                return hit ? MarkingPointer::Take::clickAlone : MarkingPointer::Take::no;
            },
            this);
        connect(pointer, &MarkingPointer::clicked, this, [this, pane](const QPointF& at) {
            if (!pane->scene()) return;
            pane->setFocus(Qt::MouseFocusReason);
            pane->passOver();
            choose(tubeCoreAt(pane->tubeCores(), pane->mapping(), at));
        });
    }
    MarkingPointer* pointer = m_parts.picture.createMarkingPointer(
        [this](const QPointF& at) {
            const bool hit = m_marks && m_parts.handIsFree() && in3dAt(at);
            return hit ? MarkingPointer::Take::click : MarkingPointer::Take::no;
        },
        this);
    connect(pointer, &MarkingPointer::clicked, this, [this](const QPointF& at) { choose(in3dAt(at)); });
    connect(&m_parts.choice, &TubeCoreChoice::chosen, this, &TubeCoresInPictures::follow);
    connect(&m_parts.choice, &TubeCoreChoice::shownChanged, this, &TubeCoresInPictures::follow);
    connect(&m_parts.otfs, &PaneOtfs::followed, this, &TubeCoresInPictures::follow);
    connect(&m_parts.panes, &ShownPanes::changed, this, &TubeCoresInPictures::follow);
    follow();
}

void TubeCoresInPictures::follow() {
    const bool drawn = m_parts.choice.shown() && !m_parts.panes.playing();
    const auto otf = drawn ? m_parts.otfs.of(PaneOtfs::adaptiveOfScene) : nullptr;
    if (otf != m_drawn) {
        m_drawn = otf;
        m_marks =
            otf && otf->design.tubeCores
                ? std::make_shared<const TubeCoreMarks>(marksOf(*otf->design.tubeCores, otf->asked.raw->geometry()))
                : nullptr;
    }
    for (PlanePane* pane : m_parts.planes)
        pane->setTubeCores({m_marks, m_marks ? m_parts.choice.number() : std::nullopt});
    m_parts.overlay.setTubeCores(m_marks ? overlayOf(*m_marks, m_parts.choice.number()) : Overlay{});
}

void TubeCoresInPictures::choose(std::optional<int> number) {
    if (!number) return;
    m_parts.choice.choose(number);
    emit clicked();
}

std::optional<int> TubeCoresInPictures::in3dAt(const QPointF& pixel) const {
    if (!m_marks) return std::nullopt;
    const double height = std::max(1, m_parts.picture.height());
    const Camera camera = m_parts.picture.shownCamera();
    std::optional<int> nearest;
    double least = reachIn3d;
    for (const int number : tubeCoresIn3d(*m_marks, m_parts.choice.number())) {
        const TubeCoreMark& mark = *m_marks->of(number);
        const auto place = placeInPicture(camera, mark.surfaceMm.value_or(mark.beginMm));
        if (!place) continue;
        const double x = m_parts.picture.width() / 2.0 + (*place)[0] * height;
        const double y = height / 2.0 + (*place)[1] * height;
        const double distance = std::hypot(pixel.x() - x, pixel.y() - y);
        if (distance >= least) continue;
        least = distance;
        nearest = number;
    }
    return nearest;
}

}  // namespace echolucent
