#include "processing/document/view_picture.h"

#include <utility>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/picture/converged.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent {

RayCastSettings castSettingsOf(const Document& document, int view, const VolumeGeometry& geometry, const DataBox& box,
                               int width, int height) {
    const Look& look = lookOf(document, view);
    const Pose pose = shownPose(document, view);
    const Cut& cut = cutOf(document, view);
    RayCastSettings settings = rayCastSettings(look);
    settings.width = width;
    settings.height = height;
    settings.camera = cameraFor(cameraPoseOf(pose, document.beam.axis, cut.nearCutMm, box, look.projection,
                                             static_cast<double>(width) / height));
    Viewpoint limits = viewpointOf(document.beam.axis, pose.direction, cut.nearCutMm);
    limits.cutSurface = cut.surface;
    limits.box = viewpointOf(document, view).box;
    return limitedTo(limits, geometry, std::move(settings));
}

std::optional<ViewPicture> viewPicture(const Document& document, int view, const Volume& scan, int width, int height,
                                       const Progress& progress) {
    const Progress silent{{}, progress.cancel};
    const SpeckleReduction reduction = lookOf(document, view).reduction;
    const auto raw = ScalpelCuts(scan.geometry()).cut(scan, strokesOf(document, view), silent);
    if (!raw) return std::nullopt;
    auto quiet = quietVolume(*raw, reduction, silent);
    if (!quiet) return std::nullopt;
    const auto voxels = std::make_shared<const Volume>(quiet->withDataBox(scan.dataBox()));
    const RayCastSettings settings =
        converged(castSettingsOf(document, view, voxels->geometry(), voxels->dataBox(), width, height));
    SampledCurve adaptive;
    std::string message;
    if (viewOf(document, view).curve == CurveKind::adaptive && settings.mode == RenderMode::direct) {
        const QuietVoxels shown =
            reduction == SpeckleReduction::off ? QuietVoxels{} : QuietVoxels{voxels.get(), reduction};
        auto otf = adaptOpacity(*raw, otfViewpointOf(document, view), configOf(document), silent, shown);
        if (!otf) return std::nullopt;
        adaptive = std::move(otf->curve);
        message = std::move(otf->message);
    }
    const OpacityCurve curve = curveOf(document, view, adaptive);
    auto picture = castRays(*voxels, curve, settings, progress);
    if (!picture) return std::nullopt;
    return ViewPicture{std::move(*picture), settings, curve, voxels, std::move(message)};
}

}  // namespace echolucent
