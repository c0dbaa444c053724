#include "processing/document/opening_finds.h"

#include <cmath>
#include <utility>

#include "processing/beam/probe_view.h"
#include "processing/choice_names.h"
#include "processing/document/side_taking.h"
#include "processing/near_cut/bright_face.h"
#include "processing/volume/coarse_grid.h"

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

constexpr ChoiceNames<3> sideSourceNames{"found", "person", "remembered"};

/// The axis of the beam that the document takes: one that is not sure stays the assumed one.
BeamAxis takenAxis(const BeamGuess& beam) { return beam.sure ? beam.axis : Beam{}.axis; }

bool looksForSides(const SaidOnOpening& said) {
    return !said.side.empty() || !(said.beam || said.direction || said.front);
}

/// The place of the side that comes first: of a large volume, the one that looks as that of its coarse volume does. No
/// value if the search was cancelled.
std::optional<std::size_t> firstSide(const Volume& volume, const OpeningFinds& finds, const SidesFinding& sides,
                                     const Progress& progress) {
    const auto coarse = coarseVolumeOf(volume);
    if (!coarse) return sides.best;
    const auto found = findOnOpening(*coarse->voxels, {{}, progress.cancel});
    if (!found) return std::nullopt;
    // The planes of fewer voxels may be unsure, and then its sides stand in another order.
    const bool sameBeam = takenAxis(found->beam) == takenAxis(finds.beam);
    return (sameBeam ? sideAlong(sides, takenAxis(finds.beam), found->side) : std::nullopt).value_or(sides.best);
}

/// Takes one of the six sides. False only if the search was cancelled.
bool takeSide(const Volume& volume, const SaidOnOpening& said, OpeningFinds& finds, const Progress& progress) {
    const Viewpoint fromProbe = viewpointOf(takenAxis(finds.beam), finds.lean);
    auto sides = findSides(volume, fromProbe, finds.beam.sure, CutShapes::flatAndCurved, progress);
    if (!sides) return false;
    const auto first = firstSide(volume, finds, *sides, progress);
    if (!first) return false;
    finds.sides = std::make_shared<const SidesFinding>(withFirst(std::move(*sides), *first));
    Sides named;
    for (std::size_t i = 0; i < named.size(); ++i) named[i] = finds.sides->sides[i].side;
    if (!said.side.empty()) {
        finds.source = SideSource::person;
        finds.place = sideNamed(named, said.side);
    } else if (const auto place = sideNamed(named, said.sideOfKind)) {
        finds.source = SideSource::remembered;
        finds.place = place;
    } else {
        finds.place = first;
    }
    const JudgedSide& taken = finds.sides->sides[finds.place.value_or(probeSide)];
    finds.side = directionOf(taken.side.view);
    if (said.front) return true;
    finds.cut = taken.front;
    finds.exposure = taken.exposure;
    return true;
}

/// Searches along the direction that a person said, or from the probe. False only if the search was cancelled.
bool takeDirection(const Volume& volume, const SaidOnOpening& said, OpeningFinds& finds, const Progress& progress) {
    finds.side = said.direction.value_or(finds.lean);
    if (said.direction) finds.source = SideSource::person;
    if (said.front) return true;
    const Viewpoint along = viewpointOf(takenAxis(finds.beam), finds.side);
    auto cut = findNearCut(volume, along, progress);
    if (!cut) return false;
    const auto face = faceIntensity(volume, behindFound(along, *cut), progress);
    if (!face) return false;
    finds.cut = std::move(*cut);
    finds.exposure = exposureFor(*face);
    return true;
}

/// All data, seen from the scene's side.
Document shownWhole(Document document, const DataBox& box, double aspect) {
    Scene& scene = document.scene;
    scene.pose = wholeVolumePose(box, viewpointOf(document.beam.axis, scene.side), scene.look.projection, aspect);
    return document;
}

}  // namespace

std::string_view nameOf(SideSource source) { return nameIn(sideSourceNames, source); }

std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress, const SaidOnOpening& said) {
    OpeningFinds finds;
    if (said.beam) {
        finds.beam = {.axis = *said.beam, .confidence = 1.0, .sure = true};
    } else {
        auto beam = guessBeamAxis(volume, progress);
        if (!beam) return std::nullopt;
        finds.beam = std::move(*beam);
        if (const auto& probe = volume.geometry().probe) finds.lean = directionOf(viewFromProbe(*probe));
    }
    const bool whole =
        looksForSides(said) ? takeSide(volume, said, finds, progress) : takeDirection(volume, said, finds, progress);
    if (!whole) return std::nullopt;
    return finds;
}

Document withFinds(Document document, const OpeningFinds& finds) {
    if (finds.beam.sure) document.beam = {finds.beam.axis, sourceOf(finds.beam.evidence), finds.lean};
    Scene& scene = document.scene;
    scene.side = finds.side;
    scene.exposure = finds.exposure;
    if (finds.cut) scene.front = frontOf(viewpointOf(document.beam.axis, finds.side), *finds.cut);
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
