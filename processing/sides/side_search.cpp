#include "processing/sides/side_search.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "processing/near_cut/bright_face.h"
#include "processing/near_cut/seen_fluid.h"
#include "processing/parallel.h"
#include "processing/sides/grain.h"

namespace echolucent {

namespace {

constexpr double closeTo = 0.9;          // of the best score: such a score is close to it
constexpr double leastOpenedSure = 0.1;  // of the picture, if the beam is sure
// If nobody knows where the probe was, the data may be no ultrasound, and what is dark no fluid.
constexpr double leastOpenedUnsure = 0.2;

using FinenessOfSides = std::array<PictureFineness, std::tuple_size_v<Sides>>;

FinenessOfSides finenessOf(const Sides& sides, const ScanPlanes& planes, const Vec3& grain) {
    FinenessOfSides all;
    double finest = 0.0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const ViewFrame frame = frameOf(sides[i].view);
        all[i].resolution = 1.0 / std::sqrt(grainAlong(frame.right, grain) * grainAlong(frame.down, grain));
        finest = std::max(finest, all[i].resolution);
    }
    for (PictureFineness& one : all) one.resolution /= finest;
    if (!planes.sure) return all;
    const Vec3 elevation = frameOf(sides[ontoPlaneSide].view).forward;
    const double inPlane = std::min(1.0, grainAlong(planes.lateral, grain) / grainAlong(elevation, grain));
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (i != ontoPlaneSide && i != ontoPlaneSide + 1) all[i].plane = inPlane;
    return all;
}

/// Rounded, so that sides that only differ by rounding are told apart by their order.
double comparedScore(const JudgedSide& judged) { return std::round(judged.score.total * 1e9) * 1e-9; }

bool opensEnough(const SidesFinding& finding, std::size_t place) {
    return finding.sides[place].score.opened >= finding.leastOpened;
}

/// The place of the side with the largest score: the first one, or one that opens enough.
std::size_t largestOf(const SidesFinding& finding) {
    std::size_t largest = probeSide;
    for (std::size_t i = 0; i < finding.sides.size(); ++i)
        if (opensEnough(finding, i) && comparedScore(finding.sides[i]) > comparedScore(finding.sides[largest]))
            largest = i;
    return largest;
}

/// Whether a side scores clearly more than the first one.
bool isClearlyMore(const SidesFinding& finding, const JudgedSide& judged) {
    return comparedScore(finding.sides[probeSide]) < closeTo * comparedScore(judged);
}

std::size_t bestOf(const SidesFinding& finding) {
    const std::size_t largest = largestOf(finding);
    return isClearlyMore(finding, finding.sides[largest]) ? largest : probeSide;
}

FirstSideReason reasonOf(const SidesFinding& finding) {
    const double score = comparedScore(finding.sides[finding.best]);
    const double largest = comparedScore(finding.sides[largestOf(finding)]);
    if (std::ranges::all_of(finding.sides, [](const JudgedSide& side) { return !(comparedScore(side) > 0.0); }))
        return FirstSideReason::nothingShows;
    if (finding.best != probeSide)
        return opensEnough(finding, finding.best) && score >= largest ? FirstSideReason::showsMost
                                                                      : FirstSideReason::firstInTheCoarsePicture;
    if (bestOf(finding) != probeSide) return FirstSideReason::firstInTheCoarsePicture;
    const bool moreElsewhere =
        std::ranges::any_of(finding.sides, [&](const JudgedSide& side) { return isClearlyMore(finding, side); });
    return moreElsewhere ? FirstSideReason::tooLittleOpenElsewhere : FirstSideReason::noneClearlyMore;
}

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

std::string sentenceOf(const SidesFinding& finding) {
    const JudgedSide& best = finding.sides[finding.best];
    const std::string first = '"' + std::string(best.side.name) + "\" comes first: ";
    const std::string opened = percent(best.score.opened) + " of its picture are surfaces behind fluid";
    switch (finding.reason) {
        case FirstSideReason::nothingShows: return first + "no side surely shows anything behind fluid.";
        case FirstSideReason::tooLittleOpenElsewhere:
            return first + "what other sides show behind fluid fills too little of their pictures.";
        case FirstSideReason::noneClearlyMore: return first + opened + ", and no other side shows clearly more.";
        case FirstSideReason::showsMost:
            return first + opened + ", seen more clearly than from any other side that opens as much.";
        case FirstSideReason::firstInTheCoarsePicture: break;
    }
    return first + "so it did in the coarse picture, which comes before all is read.";
}

}  // namespace

SidesFinding withFirst(SidesFinding finding, std::size_t place) {
    finding.best = place;
    finding.reason = reasonOf(finding);
    finding.sentence = sentenceOf(finding);
    return finding;
}

std::optional<SidesFinding> findSides(const Volume& volume, const Viewpoint& fromProbe, bool beamSure, CutShapes shapes,
                                      const Progress& progress) {
    const auto grain = grainMm(volume, progress);
    if (!grain) return std::nullopt;
    progress.at(0.2);
    const auto echo = searchedEchoOf(volume, progress);
    if (!echo) return std::nullopt;
    progress.at(0.6);
    SidesFinding finding;
    const VolumeGeometry& geometry = volume.geometry();
    finding.planes = scanPlanesOf(geometry, fromProbe, *grain);
    const Sides sides = sidesOf(fromProbe, beamSure, finding.planes);
    const FinenessOfSides fineness = finenessOf(sides, finding.planes, *grain);
    parallelFor(std::size_t{0}, sides.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        JudgedSide& judged = finding.sides[i];
        judged.side = sides[i];
        const SeenFluid seen = seenFluid(*echo, geometry, sides[i].view);
        judged.front = nearCutOf(seen, geometry, shapes);
        judged.score = scoreOf(seen, geometry, judged.front, beamSure && i == probeSide, fineness[i]);
        judged.exposure =
            exposureFor(faceIntensity(volume, behindFound(judged.side.view, judged.front), progress).value_or(0.0));
    });
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    finding.leastOpened = beamSure ? leastOpenedSure : leastOpenedUnsure;
    const std::size_t best = bestOf(finding);
    return withFirst(std::move(finding), best);
}

}  // namespace echolucent
