#include "app/planes/document_planes.h"

#include <algorithm>
#include <utility>

#include "app/planes/edge_letters.h"
#include "app/study/study_sides.h"
#include "processing/document/box_editing.h"
#include "processing/sampling/sampler.h"
#include "processing/scene/shown_measurement.h"

namespace echolucent {

DocumentPlanes::DocumentPlanes(DocumentModel& model, OpenStudy& openStudy, Works& works, const Panes& panes,
                               QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_panes(panes), m_resampler(works) {
    for (PlanePane* pane : m_panes) {
        connect(pane, &PlanePane::changed, this, [this, pane](const Planes& next, const QString& what) {
            if (!pane->dragging()) return take(next, what, m_model.gesture());
            const Document turned = with(next);
            const bool moves = turned.scene.pose != m_model.document().scene.pose;
            m_model.preview(turned, what);
            if (moves) emit cameraMoved();
        });
        connect(pane, &PlanePane::boxDragged, this, &DocumentPlanes::takeBox);
        connect(pane, &PlanePane::frontWheeled, this, &DocumentPlanes::wheelFront);
        connect(pane, &PlanePane::dragEnded, this, [this](const QString& what) {
            m_beforeBoxDrag.reset();
            if (m_model.previewing()) take(m_model.document().scene.planes, what, m_model.gesture());
        });
        connect(pane, &PlanePane::dragCancelled, this, [this] {
            m_beforeBoxDrag.reset();
            m_model.cancelPreview();
        });
        // This step has the gesture and the name of the first click's step, and undoes it: together they are no step.
        connect(pane, &PlanePane::clickTakenBack, this,
                [this](const Planes& before, const QString& what) { take(before, what, m_newestGesture); });
        connect(pane, &PlanePane::wantsOther, this, &DocumentPlanes::resample);
        connect(pane, &PlanePane::pointed, this, [this](const std::optional<Vec3>& gridMm) {
            const std::shared_ptr<const Volume> read = m_openStudy.volume();
            if (!gridMm || !read) return emit pointed(std::nullopt);
            const Vec3 voxel = read->geometry().voxelFromGridMm(*gridMm);
            emit pointed(inBox(read->geometry(), voxel) ? VolumeSampler(*read).intensityAt(voxel) : std::nullopt);
        });
    }
    connect(&m_model, &DocumentModel::changed, this, &DocumentPlanes::show);
    connect(&m_openStudy, &OpenStudy::volumeChanged, this, &DocumentPlanes::show);
    connect(&m_openStudy, &OpenStudy::quietVoxelsMade, this, &DocumentPlanes::show);
    connect(&m_openStudy, &OpenStudy::volumeCut, this, &DocumentPlanes::show);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, [this] {
        cancelDrag();
        // Never show one study's voxels under the lines of another.
        for (PlanePane* pane : m_panes) pane->clear();
        show();
    });
    connect(&m_resampler, &PlaneResampler::resampled, this,
            [this](PlaneName plane, const std::shared_ptr<const PlaneSamples>& samples) {
                m_panes[indexOf(plane)]->setSamples(samples);
            });
    show();
}

void DocumentPlanes::show() {
    const std::shared_ptr<const Volume> volume = m_openStudy.volume();
    const BoxScene box = volume ? boxScene(*volume) : BoxScene{};
    for (PlanePane* pane : m_panes) volume ? pane->setScene(sceneFor(*volume, box, pane->plane())) : pane->clear();
    resample();
}

PlaneScene DocumentPlanes::sceneFor(const Volume& volume, const BoxScene& box, PlaneName plane) const {
    const Document& document = m_model.document();
    PlaneScene scene;
    scene.planes = document.scene.planes;
    scene.beam = document.beam.axis;
    scene.data = volume.dataBox();
    scene.unitMm = volume.geometry().unit();
    scene.lengthsKnown = volume.geometry().spacingKnown;
    scene.brightness = document.scene.look.brightness;
    scene.box = box;
    scene.measurements = shownMeasurements(document.measurements, phaseOf(document, firstPane), volume.geometry());
    const ViewFrame frame = frameOf(plane, scene.planes, scene.beam);
    const bool isSure = beamIsSure(document.beam, m_openStudy);
    const EdgeLetters letters =
        edgeLetters(frame, isSure ? std::optional(scene.beam) : std::nullopt, volume.geometry());
    scene.letters = letters.words;
    scene.lettersNameProbe = letters.nameProbe;
    if (isSure) {
        scene.towardsProbe = towardsProbe(frame, scene.beam);
        scene.lie = lieOf(frame, scene.beam);
    }
    return scene;
}

BoxScene DocumentPlanes::boxScene(const Volume& volume) const {
    const Document& document = m_model.document();
    const Box& box = document.scene.box;
    BoxScene scene;
    scene.leastMm = volume.geometry().unit();
    if (box.on) scene.box = orientedBoxOf(box, document.beam.axis);
    if (cuts(document.scene.front)) scene.front = surfaceOfFront(document, volume);
    return scene;
}

void DocumentPlanes::resample() {
    const std::shared_ptr<const Volume> volume =
        m_model.document().scene.planes.quiet ? m_openStudy.newestVoxels() : m_openStudy.volume();
    std::array<std::optional<PlaneRequest>, 3> requests;
    for (const PlanePane* pane : m_panes) requests[indexOf(pane->plane())] = pane->wanted(volume);
    m_resampler.want(requests);
}

void DocumentPlanes::take(const Planes& next, const QString& what, DocumentModel::Gesture gesture) {
    m_newestGesture = gesture;
    const Document turned = with(next);
    const bool moves = turned.scene.pose != m_model.document().scene.pose;
    m_model.edit(turned, what, gesture);
    if (moves) emit cameraMoved();
}

void DocumentPlanes::takeBox(const BoxGrip& grip, const BoxDrag& dragged, const QString& what) {
    // The drag counts from the document at its beginning. Other changes since then stay.
    if (!m_beforeBoxDrag) m_beforeBoxDrag = m_model.document();
    const Document& before = *m_beforeBoxDrag;
    Document next = m_model.document();
    switch (grip.kind) {
        case BoxGrip::Kind::bow: next.scene.front = {.surface = dragged.front}; break;
        case BoxGrip::Kind::front: next.scene.front = movedFront(before, dragged.frontMm); break;
        default: next.scene.box = movedBox(before.scene.box, dragged.box, before.beam.axis);
    }
    m_model.preview(next, what);
}

/// The front of a document, moved along its own forward as far as the volume reaches.
Front DocumentPlanes::movedFront(const Document& document, double mm) const {
    const VolumeGeometry& geometry = m_openStudy.volume()->geometry();
    return movedBy(document.scene.front, mm, document.beam.axis, geometry);
}

void DocumentPlanes::wheelFront(double mm, const QString& what) {
    Document next = m_model.document();
    next.scene.front = movedFront(next, mm);
    m_model.edit(next, what, m_model.gesture());
}

Document DocumentPlanes::with(const Planes& next) const {
    Document document = m_model.document();
    const Planes before = std::exchange(document.scene.planes, next);
    if (!next.turnsView || next.direction == before.direction) return document;
    // As wherever a hand moves the camera, a motion starts anew from what is shown.
    document.scene.pose = turnedAlong(shownPose(document), before, next, document.beam.axis);
    document.scene.motionAngle = 0.0;
    return document;
}

void DocumentPlanes::resetAll() {
    const Planes& now = m_model.document().scene.planes;
    Planes start;
    start.quiet = now.quiet;
    start.linesIn3d = now.linesIn3d;
    start.turnsView = now.turnsView;
    take(start, tr("reset planes"), DocumentModel::noGesture);
}

bool DocumentPlanes::cancelDrag() {
    bool cancelled = false;
    for (PlanePane* pane : m_panes) cancelled = pane->cancelDrag() || cancelled;
    return cancelled;
}

}  // namespace echolucent
