#include "processing/sides/side_score.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace echolucent {

namespace {

constexpr double samplesOfExtent = 64.0;  // SmoothEcho: a cell is a 64th of the data's extent
constexpr double halfDepth = 0.2;         // of the extent: surfaces so deep behind the front count half
constexpr double faintContrast = 0.47, fullContrast = 1.61;  // ln 1.6 (every wall has it), and ln 5
constexpr double clearFluid =
    1.3;  // contrast at the border of the data that dim tissue has not, as findNearCut() has it
constexpr double darkLevel = 0.45;  // of tissue: a tube core that stays darker shows nothing
/// Side by side, a disc's cells have 4 diameters of rim: it is counted along rows and columns.
constexpr double rimOfDisc = 8.0 * std::numbers::inv_sqrtpi;

/// What a tube core shows.
struct ShownTube {
    int begin = -1;    ///< its first sample with data behind the front; -1: it is no part of the picture
    int surface = -1;  ///< the sample of the wall behind the fluid in which it begins; -1: it is not open
    [[nodiscard]] bool open() const { return surface >= 0; }
};

int firstData(const float* echo, int from, int samples) {
    for (int sample = from; sample < samples; ++sample)
        if (echo[sample] >= 0.0F) return sample;
    return -1;
}

/// Fluid before surfaces: what tube cores begin in.
struct FluidBefore {
    double contrast = 0.0, samples = 0.0;
};

FluidBefore findSurfaces(const SeenFluid& seen, std::vector<ShownTube>& shown) {
    constexpr int borderSamples = 2;  // a stretch at the front may begin with the second sample of data
    FluidBefore fluid;
    for (const auto& stretches : seen.levels)
        for (const FluidStretch& stretch : stretches) {
            ShownTube& tube = shown[static_cast<std::size_t>(stretch.tube)];
            const int begin = stretch.begin - (stretch.atFront ? borderSamples - 1 : 0);
            if (tube.begin < begin || tube.begin >= stretch.end) continue;
            tube.surface = std::max(tube.surface, stretch.end);
            fluid.contrast += stretch.contrast * stretch.length();
            fluid.samples += stretch.length();
        }
    return fluid;
}

/// Counts the pairs of neighbouring tube cores of which one is open and the other is not.
int rimOf(const TubeEcho& tubes, const std::vector<ShownTube>& shown) {
    int rim = 0;
    const auto compare = [&](const ShownTube& one, const ShownTube& other) {
        if (one.begin >= 0 && other.begin >= 0 && one.open() != other.open()) ++rim;
    };
    const auto columns = static_cast<std::size_t>(tubes.columns);
    for (std::size_t tube = 0; tube < shown.size(); ++tube) {
        if (tube % columns + 1 < columns) compare(shown[tube], shown[tube + 1]);
        if (tube + columns < shown.size()) compare(shown[tube], shown[tube + columns]);
    }
    return rim;
}

bool isTrusted(const SeenFluid& seen, const NearCutFinding& front, bool alongBeam) {
    switch (front.answer) {
        case NearCutAnswer::fluidAtFront: return alongBeam || (front.sure && seen.frontContrast >= clearFluid);
        case NearCutAnswer::wallBeforeFluid: return front.sure;
        case NearCutAnswer::noFluid: break;
    }
    return false;
}

}  // namespace

std::vector<int> firstShownSamples(const SeenFluid& seen, const VolumeGeometry& geometry, const NearCutFinding& front) {
    const TubeEcho& tubes = seen.tubes;
    std::vector<int> first(tubes.tubes());
    if (!makesFront(front)) return first;
    const double flatMm = geometry.depthsAlong(tubes.frame.forward).nearest + front.nearCutMm;
    for (std::size_t tube = 0; tube < first.size(); ++tube) {
        const auto columns = static_cast<std::size_t>(tubes.columns);
        const Vec3 place =
            tubes.frame.right * (tubes.firstRightMm + static_cast<double>(tube % columns) * tubes.stepMm) +
            tubes.frame.down * (tubes.firstDownMm + static_cast<double>(tube / columns) * tubes.stepMm);
        const double depthMm = front.surface ? front.surface->depthAt(place) : flatMm;
        first[tube] = std::max(0, static_cast<int>(std::lround((depthMm - tubes.firstDepthMm) / tubes.stepMm)));
    }
    return first;
}

SideScore scoreOf(const SeenFluid& seen, const VolumeGeometry& geometry, const NearCutFinding& front, bool alongBeam,
                  const PictureFineness& fineness) {
    SideScore score;
    score.fineness = fineness;
    const TubeEcho& tubes = seen.tubes;
    const std::vector<int> first = firstShownSamples(seen, geometry, front);
    std::vector<ShownTube> shown(tubes.tubes());
    int picture = 0;
    for (std::size_t tube = 0; tube < shown.size(); ++tube) {
        shown[tube].begin = firstData(tubes.tube(tube), first[tube], tubes.samples);
        if (shown[tube].begin >= 0) ++picture;
    }
    if (picture == 0) return score;
    const FluidBefore fluid = findSurfaces(seen, shown);
    int opened = 0, dark = 0;
    double squares = 0.0;
    for (std::size_t tube = 0; tube < shown.size(); ++tube) {
        const ShownTube& one = shown[tube];
        if (one.begin < 0) continue;
        if (one.open()) {
            ++opened;
            squares += static_cast<double>(one.surface - one.begin) * (one.surface - one.begin);
        } else if (const float* echo = tubes.tube(tube);
                   *std::max_element(echo + one.begin, echo + tubes.samples) < darkLevel * seen.tissue) {
            ++dark;
        }
    }
    score.shown = 1.0 - static_cast<double>(dark) / picture;
    if (opened == 0) return score;
    score.opened = static_cast<double>(opened) / picture;
    score.area = opened / (samplesOfExtent * samplesOfExtent);
    score.depth = std::sqrt(squares / opened) / samplesOfExtent;
    score.contrast = fluid.contrast / fluid.samples;
    score.wholeness = std::min(1.0, rimOfDisc * std::sqrt(opened) / std::max(1, rimOf(tubes, shown)));
    if (isTrusted(seen, front, alongBeam))
        score.total = score.area * score.depth / (score.depth + halfDepth) *
                      std::clamp((score.contrast - faintContrast) / (fullContrast - faintContrast), 0.0, 1.0) *
                      score.wholeness * score.shown * std::sqrt(fineness.resolution) * fineness.plane;
    return score;
}

}  // namespace echolucent
