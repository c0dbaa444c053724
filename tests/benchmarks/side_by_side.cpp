#include "tests/benchmarks/side_by_side.h"

#include <algorithm>

#include "processing/ray_caster/ray_caster.h"

namespace echolucent::bench {

namespace {

constexpr double slowFrameMs = 1000.0;
constexpr int repeatsOfSlowFrames = 3;

Cost castCost(RayCaster& caster, const OpacityCurve& curve, const RayCastSettings& settings) {
    return costOf([&] { (void)caster.cast(curve, settings); });
}

Cost coarseCost(RayCaster& caster, const OpacityCurve& curve, const RayCastSettings& settings,
                const RayCoarseness& coarseness) {
    return costOf([&] {
        const auto picture = caster.cast(curve, coarsened(settings, coarseness));
        (void)onScreen(*picture, settings.width);
    });
}

}  // namespace

RayCastSettings turnedSettings(const BenchVolume& volume, const RayCastSettings& look, int size, double turnDegrees) {
    RayCastSettings settings = benchSettings(volume, size, turnDegrees);
    settings.step = look.step;
    settings.terminationTransmittance = look.terminationTransmittance;
    settings.shading = look.shading;
    settings.colourMap = look.colourMap;
    return settings;
}

SideBySide measureSideBySide(const Contenders& contenders, const OpacityCurve& curve, const RayCastSettings& look,
                             int size, int repeats) {
    const auto turned = [&](int frame) {
        return turnedSettings(contenders.volume, look, size, turnBetweenFrames * frame);
    };
    SideBySide result;
    result.oursFirst = castCost(contenders.ours, curve, turned(-1));
    result.vtkFirst = contenders.vtk.draw(turned(-1)).frame;
    if (contenders.oursMasked) (void)contenders.oursMasked->cast(curve, turned(-1));
    std::vector<Cost> ours, coarse, reaching, masked, rays, setUp, frame;
    for (int i = 1; i <= repeats; ++i) {
        const RayCastSettings settings = turned(3 * i);
        ours.push_back(castCost(contenders.ours, curve, settings));
        // Under the camera of the picture before, ours would keep samples as for an edit.
        if (settings.shading) {
            RayCastSettings lit = turned(3 * i + 1);
            lit.shading->reaching = ReachingLight{};
            reaching.push_back(castCost(contenders.ours, curve, lit));
        }
        if (contenders.coarse)
            coarse.push_back(coarseCost(contenders.ours, curve, turned(3 * i + 2), *contenders.coarse));
        const VtkFrameCost vtk = contenders.vtk.draw(settings);
        rays.push_back(vtk.rays);
        setUp.push_back(vtk.setUp);
        frame.push_back(vtk.frame);
        if (contenders.oursMasked) masked.push_back(castCost(*contenders.oursMasked, curve, settings));
        if (i >= repeatsOfSlowFrames && vtk.rays.wallMs > slowFrameMs) break;
    }
    result.repeats = static_cast<int>(ours.size());
    result.ours = medianOf(ours);
    if (look.shading) result.oursReaching = medianOf(reaching);
    if (contenders.coarse) result.oursCoarse = medianOf(coarse);
    result.vtkRays = medianOf(rays);
    result.vtkSetUp = medianOf(setUp);
    result.vtkFrame = medianOf(frame);
    if (contenders.oursMasked) result.oursMasked = medianOf(masked);
    return result;
}

}  // namespace echolucent::bench
