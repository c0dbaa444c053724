#include "processing/document/opening_finds.h"

#include <cmath>
#include <utility>

#include "processing/beam/probe_view.h"
#include "processing/near_cut/bright_face.h"

namespace echolucent {

namespace {

BeamSource sourceOf(BeamEvidence evidence) {
    switch (evidence) {
        case BeamEvidence::file: return BeamSource::file;
        case BeamEvidence::sectorShape: return BeamSource::sectorShape;
        case BeamEvidence::echo: return BeamSource::echo;
        case BeamEvidence::none: break;
    }
    return BeamSource::person;
}

ViewDirection sideOf(const OpeningFinds& finds) { return finds.side.value_or(finds.lean); }

/// All data, seen from the scene's side.
Document shownWhole(Document document, const DataBox& box, double aspect) {
    Scene& scene = document.scene;
    scene.pose = wholeVolumePose(box, viewpointOf(document.beam.axis, scene.side), scene.look.projection, aspect);
    return document;
}

}  // namespace

std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress, const SaidOnOpening& said,
                                          NearCutSearch search) {
    OpeningFinds finds;
    finds.side = said.side;
    if (said.beam) {
        finds.beam = {.axis = *said.beam, .confidence = 1.0, .sure = true};
    } else {
        auto beam = guessBeamAxis(volume, progress);
        if (!beam) return std::nullopt;
        finds.beam = std::move(*beam);
        if (const auto& probe = volume.geometry().probe) finds.lean = directionOf(viewFromProbe(*probe));
    }
    if (said.front || (!finds.beam.sure && !said.side)) return finds;
    finds.cut = search(volume, viewpointOf(finds.beam.axis, sideOf(finds)), progress);
    if (!finds.cut) return std::nullopt;
    const double nearCutMm = makesFront(finds) ? finds.cut->nearCutMm : 0.0;
    const Viewpoint shown = withFrontAcross(viewpointOf(finds.beam.axis, sideOf(finds)), nearCutMm);
    const auto face = faceIntensity(volume, shown, progress);
    if (!face) return std::nullopt;
    finds.exposure = exposureFor(*face);
    return finds;
}

bool makesFront(const OpeningFinds& finds) {
    return finds.cut && finds.cut->sure && finds.cut->answer == NearCutAnswer::wallBeforeFluid;
}

Document withFinds(Document document, const OpeningFinds& finds) {
    if (!finds.beam.sure && !finds.side) return document;
    if (finds.beam.sure) document.beam = {finds.beam.axis, sourceOf(finds.beam.evidence), finds.lean};
    document.scene.side = sideOf(finds);
    document.scene.exposure = finds.exposure;
    if (makesFront(finds))
        document.scene.front =
            frontAcross(sideOf(finds), std::round(10 * finds.cut->nearCutMm) / 10, FrontSource::found);
    return document;
}

OpenedDocuments openedDocuments(const Document& before, const OpenedStudy& study, double aspect) {
    Document plain = shownWhole(openedDocument(before, study.reference), study.box, aspect);
    if (study.phases < 2)
        plain.motion.scenario = MotionScenario::probe;
    else if (study.phasesBefore < 2)  // from one 4D study to the next, the chosen motion stays
        plain.motion.scenario = MotionScenario::object;
    Document found = study.finds ? shownWhole(withFinds(plain, *study.finds), study.box, aspect) : plain;
    return {std::move(plain), std::move(found)};
}

}  // namespace echolucent
