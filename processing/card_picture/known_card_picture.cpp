#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "processing/card_picture/card_picture.h"
#include "processing/card_picture/card_pictures.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent {

namespace {

constexpr int edge = 32;  // voxels, and pixels

/// A ball with grain in fluid. It lies beside the middle along every axis, so that a picture that is flipped or turned
/// differs.
std::shared_ptr<const Volume> ballBesideTheMiddle() {
    VolumeGeometry geometry;
    geometry.size = {edge, edge, edge};
    std::vector<std::uint8_t> voxels, mask;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const double inside = std::clamp(9.0 - length(Vec3(x, y, z) - Vec3(13, 17, 18)), 0.0, 2.0) / 2.0;
                const double grain = std::sin(1.3 * x) * std::sin(1.1 * y + 0.5) * std::sin(0.9 * z);
                voxels.push_back(static_cast<std::uint8_t>(std::lround(20.0 + inside * (130.0 + 40.0 * grain))));
                mask.push_back(x + y + z < 70 ? 1 : 0);
            }
    return std::make_shared<const Volume>(Volume(geometry, std::move(voxels)).withDataMask(std::move(mask)));
}

}  // namespace

KnownCardPicture knownCardPicture() {
    const auto volume = ballBesideTheMiddle();
    RayCastSettings settings;
    settings.width = settings.height = edge;
    settings.camera = defaultCamera(volume->dataBox(), Viewpoint{BeamAxis::plusZ, 25.0, 15.0}, 1.0);
    settings.front = CuttingFace{settings.camera.frame.forward,
                                 settings.camera.frame.forward.dot(volume->geometry().centreMm()) - 4.0};
    settings.step = 0.75;
    settings.shading = Shading{};
    settings.shading->reaching = ReachingLight{};
    const OpacityCurve curve = PowerCurve{2, 1.0};
    return {CardPictures(volume).make(curve, settings).value(), castRays(*volume, curve, settings).value()};
}

}  // namespace echolucent
