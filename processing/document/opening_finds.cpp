#include "processing/document/opening_finds.h"

#include <cmath>
#include <utility>

#include "processing/beam/probe_view.h"

namespace echolucent {

namespace {

BeamSource sourceOf(BeamEvidence evidence) {
    switch (evidence) {
        case BeamEvidence::file: return BeamSource::file;
        case BeamEvidence::sectorShape: return BeamSource::sectorShape;
        case BeamEvidence::echo:
        case BeamEvidence::none: break;
    }
    return BeamSource::echo;
}

}  // namespace

std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress) {
    auto beam = guessBeamAxis(volume, progress);
    if (!beam) return std::nullopt;
    OpeningFinds finds{.beam = std::move(*beam)};
    if (const auto& probe = volume.geometry().probe) finds.lean = directionOf(viewFromProbe(*probe));
    if (!finds.beam.sure) return finds;
    finds.cut = findNearCut(volume, viewpointOf(finds.beam.axis, finds.lean, 0.0), progress);
    if (!finds.cut) return std::nullopt;
    return finds;
}

Document withFinds(Document document, const OpeningFinds& finds) {
    if (!finds.beam.sure) return document;
    document.beam = {finds.beam.axis, sourceOf(finds.beam.evidence), finds.lean};
    document.scene.side = finds.lean;
    if (!finds.cut || !finds.cut->sure || finds.cut->answer != NearCutAnswer::wallBeforeFluid) return document;
    document.scene.front = {.depthMm = std::round(10 * finds.cut->nearCutMm) / 10, .source = FrontSource::found};
    return document;
}

}  // namespace echolucent
