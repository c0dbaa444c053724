#include "processing/document/opening_finds.h"

#include <cmath>
#include <utility>

namespace echolucent {

namespace {

BeamSource sourceOf(BeamEvidence evidence) {
    return evidence == BeamEvidence::sectorShape ? BeamSource::sectorShape : BeamSource::echo;
}

}  // namespace

std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress) {
    auto beam = guessBeamAxis(volume, progress);
    if (!beam) return std::nullopt;
    OpeningFinds finds{.beam = std::move(*beam)};
    if (!finds.beam.sure) return finds;
    finds.cut = findNearCut(volume, Viewpoint{.beamAxis = finds.beam.axis}, progress);
    if (!finds.cut) return std::nullopt;
    return finds;
}

Document withFinds(Document document, const OpeningFinds& finds) {
    if (!finds.beam.sure) return document;
    document.beam = {finds.beam.axis, sourceOf(finds.beam.evidence)};
    if (!finds.cut || !finds.cut->sure || finds.cut->answer != NearCutAnswer::wallBeforeFluid) return document;
    for (Shared<Cut>& cut : document.cuts)
        cut.value = {.nearCutMm = std::round(10 * finds.cut->nearCutMm) / 10, .source = CutSource::found};
    return document;
}

}  // namespace echolucent
