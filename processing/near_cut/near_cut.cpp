#include "processing/near_cut/near_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "processing/choice_names.h"
#include "processing/near_cut/curved_cut.h"
#include "processing/near_cut/flat_cut.h"
#include "processing/near_cut/fluid_stretches.h"
#include "processing/near_cut/tube_echo.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> answerNames{"fluid at the front", "wall before fluid", "no fluid"};

constexpr double leastFluid = 0.004;  // of the data's samples
// The fluid is at the front if `mostlyAtFront` of the tube cores that meet data begin in fluid. `someAtFront` of them
// are enough if they are also `farMoreAtFront` times as many as a cut would open: dim tissue may begin at the front
// too. If their stretches have `clearFrontContrast` in the mean, which dim tissue has not, `moreAtFront` times as many
// are enough. Then it is also enough if `mostlySurrounded` of the tube cores that a cut would open begin in fluid.
constexpr double mostlyAtFront = 0.5;
constexpr double someAtFront = 0.1;
constexpr double farMoreAtFront = 12.0;
constexpr double moreAtFront = 3.0;
constexpr double clearFrontContrast = 1.3;
constexpr double mostlySurrounded = 0.5;
constexpr double clearFluid = 0.03;                           // of the data: this much fluid is beyond doubt
constexpr double faintContrast = 0.47, clearContrast = 0.77;  // ln 1.6 (every wall has it), and ln 2.16
constexpr double sureFrom = 0.5;
constexpr double asManyAsFlat = 0.95;  // of the tube cores in fluid at the flat cut: with fewer there is no curved cut

/// The stretches of the highest level that stand behind a wall.
std::vector<FluidStretch> behindWalls(const SeenFluid& seen) {
    std::vector<FluidStretch> walled;
    std::copy_if(seen.levels.back().begin(), seen.levels.back().end(), std::back_inserter(walled),
                 [](const FluidStretch& stretch) { return !stretch.atFront; });
    return walled;
}

void addSurface(const SeenFluid& seen, int flatSample, NearCutFinding& finding) {
    const TubeEcho& tubes = seen.tubes;
    finding.surface = fitCurvedCut(tubes, behindWalls(seen), flatSample);
    if (!finding.surface) return;
    const auto depthOf = [&](int tube) {
        const int column = tube % tubes.columns, row = tube / tubes.columns;
        const Vec3 place = tubes.frame.right * (tubes.firstRightMm + column * tubes.stepMm) +
                           tubes.frame.down * (tubes.firstDownMm + row * tubes.stepMm);
        return (finding.surface->depthAt(place) - tubes.firstDepthMm) / tubes.stepMm;
    };
    finding.tubesInFluidBehindSurface = tubesInFluid(seen.levels, tubes.tubes(), depthOf);
    if (finding.tubesInFluidBehindSurface < asManyAsFlat * finding.tubesThatSaySo) finding.surface.reset();
}

double clampedShare(double value, double from, double to) { return std::clamp((value - from) / (to - from), 0.0, 1.0); }

/// A finding without its curved cut and its sentence; nearCutMm is counted from the grid's origin. `flatSample` is the
/// sample at which the flat cut lies.
struct Judged {
    NearCutFinding finding;
    int flatSample = 0;
};

Judged judged(const SeenFluid& seen) {
    NearCutFinding finding;
    finding.tubes = seen.meetData;
    const FlatCut flat = findFlatCut(seen.tubes, seen.levels);
    const int opened = tubesInFluid(seen.levels, seen.tubes.tubes(), [&](int) { return flat.sample; });
    constexpr int nowhere = -1;
    const int openedBehindFluid = tubesInFluid(seen.levels, seen.tubes.tubes(), [&](int tube) {
        return seen.beginsInFluid[static_cast<std::size_t>(tube)] ? flat.sample : nowhere;
    });
    const double frontShare = static_cast<double>(seen.beginInFluid) / std::max(1, seen.meetData);
    const bool clearFront = seen.frontContrast >= clearFrontContrast;
    const double timesOpened = clearFront ? moreAtFront : farMoreAtFront;
    // In a wide sector few tube cores begin in the fluid at the front. This fluid surrounds the tissue if at least half
    // of the tube cores that a cut would open begin in fluid.
    const bool surrounds = clearFront && openedBehindFluid >= mostlySurrounded * opened;
    if (frontShare >= mostlyAtFront ||
        (frontShare >= someAtFront && (seen.beginInFluid >= timesOpened * opened || surrounds))) {
        finding.answer = NearCutAnswer::fluidAtFront;
        finding.tubesThatSaySo = seen.beginInFluid;
        finding.confidence = frontShare;
    } else if (flat.fluid < leastFluid) {
        finding.tubesThatSaySo = seen.meetData - seen.meetFluid;
        finding.confidence = seen.meetData > 0 ? 1.0 - flat.fluid / leastFluid : 0.0;
    } else {
        finding.answer = NearCutAnswer::wallBeforeFluid;
        finding.tubesThatSaySo = opened;
        finding.confidence = clampedShare(flat.fluid, 0.0, clearFluid) *
                             clampedShare(flat.contrast, faintContrast, clearContrast) * (1.0 - frontShare);
        finding.behindDataMm = (flat.sample - seen.front) * seen.tubes.stepMm;
        finding.nearCutMm = seen.tubes.depthMm(flat.sample);  // from the grid's origin; found() makes it relative
    }
    finding.sure = finding.confidence >= sureFrom;
    return {std::move(finding), flat.sample};
}

std::string oneDecimal(double value) {
    const auto tenths = static_cast<long>(std::lround(10.0 * value));
    return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
}

std::string sentenceOf(const NearCutFinding& finding, bool spacingKnown) {
    const std::string of =
        std::to_string(finding.tubesThatSaySo) + " of " + std::to_string(finding.tubes) + " tube cores ";
    const std::string doubt = finding.sure ? "" : " The search is not sure.";
    switch (finding.answer) {
        case NearCutAnswer::fluidAtFront:
            return "The data begin in fluid (" + of + "begin in it): no front is needed." + doubt;
        case NearCutAnswer::wallBeforeFluid:
            return "A wall stands before the fluid: behind a front at " + oneDecimal(finding.nearCutMm) + " mm " +
                   (spacingKnown ? "" : "(by a guessed spacing) ") + of + "are in fluid." + doubt;
        case NearCutAnswer::noFluid:
            if (finding.tubes == 0) return "No tube core meets data here, so no front can be found.";
            return "No fluid was found (" + of + "meet none), so no front can be found." + doubt;
    }
    return {};
}

std::optional<NearCutFinding> found(const Volume& volume, const Viewpoint& view, const Progress& progress,
                                    CutShapes shapes) {
    const auto echo = view.box ? searchedEchoOf(volume.withDataMask(dataMaskWithin(*view.box, volume)), progress)
                               : searchedEchoOf(volume, progress);
    if (!echo) return std::nullopt;
    progress.at(0.6);
    const SeenFluid seen = seenFluid(*echo, volume.geometry(), view);
    if (progress.cancelled()) return std::nullopt;
    progress.at(0.8);
    NearCutFinding finding = nearCutOf(seen, volume.geometry(), shapes);
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    return finding;
}

}  // namespace

std::string_view nameOf(NearCutAnswer answer) { return nameIn(answerNames, answer); }

bool makesFront(const NearCutFinding& finding) {
    return finding.sure && finding.answer == NearCutAnswer::wallBeforeFluid;
}

std::string messageOfFront(const NearCutFinding& finding) {
    if (!makesFront(finding) || !finding.surface) return finding.message;
    return "A wall stands before the fluid: behind a bowed front " + std::to_string(finding.tubesInFluidBehindSurface) +
           " of " + std::to_string(finding.tubes) + " tube cores are in fluid.";
}

Viewpoint behindFound(Viewpoint view, const NearCutFinding& finding) {
    if (!makesFront(finding)) return view;
    if (!finding.surface) return withFrontAcross(std::move(view), finding.nearCutMm);
    view.cutSurface = finding.surface;
    return view;
}

NearCutFinding nearCutOf(const SeenFluid& seen, const VolumeGeometry& geometry, CutShapes shapes) {
    auto [finding, flatSample] = judged(seen);
    if (finding.answer == NearCutAnswer::wallBeforeFluid) {
        if (shapes == CutShapes::flatAndCurved) addSurface(seen, flatSample, finding);
        finding.nearCutMm = std::max(0.0, finding.nearCutMm - geometry.depthsAlong(seen.tubes.frame.forward).nearest);
    }
    finding.message = sentenceOf(finding, geometry.spacingKnown);
    return finding;
}

std::optional<NearCutFinding> findNearCut(const Volume& volume, const Viewpoint& view, const Progress& progress) {
    return found(volume, view, progress, CutShapes::flatAndCurved);
}

std::optional<NearCutFinding> findFlatNearCut(const Volume& volume, const Viewpoint& view, const Progress& progress) {
    return found(volume, view, progress, CutShapes::flat);
}

}  // namespace echolucent
