#include "processing/pane_picture/coarse_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/opening_finds.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent {

namespace {

// Along the picture's shorter edge: three rays for two voxels of the largest grid.
constexpr double mostRays = 1.5 * static_cast<double>(mostCoarseVoxels);
constexpr int curveSamples = 2041;  // as many as in the ray caster's own table

int raysFor(int pixels, double reduction) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(pixels) / reduction)));
}

/// The curve per unit of the coarse grid, which is `units` units of the volume long. It shows what `curve` shows per
/// unit of the volume.
SampledCurve overUnits(const OpacityCurve& curve, double units) {
    SampledCurve longer{sampledOpacities(curve, curveSamples)};
    for (double& opacity : longer.opacities) opacity = opacityForStep(opacity, units);
    return longer;
}

}  // namespace

std::optional<Picture> coarsePicture(const Document& before, std::size_t pane, const CoarseVolume& coarse, int width,
                                     int height, const Progress& progress) {
    const Progress silent{{}, progress.cancel};
    const Volume& volume = *coarse.voxels;
    const auto finds = findOnOpening(volume, silent);
    if (!finds) return std::nullopt;
    const Document document =
        openedDocuments(before, {.box = volume.dataBox(), .finds = finds}, static_cast<double>(width) / height).found;
    SampledCurve adaptive;
    // No designer is asked about so few voxels: the pane's curve stands in for its OTF.
    if (document.panes.at(pane).curve == CurveKind::adaptive && document.scene.look.mode == RenderMode::direct) {
        auto otf = adaptOpacity(volume, otfViewpointOf(document, pane), configOf(document), silent);
        if (!otf) return std::nullopt;
        adaptive = std::move(otf->curve);
    }
    const double reduction = std::max(1.0, std::min(width, height) / mostRays);
    const RayCastSettings settings = castSettingsOf(document, volume.geometry(), volume.dataBox(),
                                                    raysFor(width, reduction), raysFor(height, reduction));
    return castRays(volume, overUnits(curveOf(document, pane, adaptive), coarse.units), settings, silent);
}

}  // namespace echolucent
