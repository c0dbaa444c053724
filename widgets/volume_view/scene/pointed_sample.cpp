#include "widgets/volume_view/scene/pointed_sample.h"

#include <cmath>
#include <vector>

#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/sampling/sampler.h"

namespace echolucent {

namespace {

double opacityOf(const PaneRequest& pane, const Vec3& voxel, double intensity) {
    const double gradient = pane.classification.isTwoDimensional() ? GradientMagnitude(*pane.volume).at(voxel) : 0.0;
    return opacityAt(pane.classification, intensity, gradient);
}

std::optional<PointedSample> sampleByOpacity(const PaneRequest& pane, const RayCastSettings& settings,
                                             const std::vector<RaySample>& ray) {
    constexpr double visible = 1.0 / 255.0;  // a smaller opacity does not show on a screen
    double transmittance = 1.0, largest = 0.0;
    std::optional<PointedSample> pointed;
    for (const RaySample& sample : ray) {
        if (!sample.intensity) continue;
        const double opacity = opacityOf(pane, sample.voxel, *sample.intensity);
        const double share = opacityForStep(opacity, settings.step * sample.length);
        const bool half = transmittance * (1.0 - share) <= 0.5;
        if (half || transmittance * share > largest) {
            largest = transmittance * share;
            pointed = PointedSample{*sample.intensity, opacity, pane.volume->geometry().gridMmFromVoxel(sample.voxel)};
        }
        transmittance *= 1.0 - share;
        if (half) break;
    }
    return 1.0 - transmittance < visible ? std::nullopt : pointed;
}

std::optional<PointedSample> sampleByIntensity(const PaneRequest& pane, const RayCastSettings& settings,
                                               const std::vector<RaySample>& ray) {
    const RenderMode mode = settings.mode;
    std::optional<PointedSample> pointed;
    double sum = 0.0, steps = 0.0;
    for (const RaySample& sample : ray) {
        if (!sample.intensity) continue;
        const double intensity = *sample.intensity;
        const bool chosen = !pointed || (mode == RenderMode::maximum && intensity > pointed->intensity) ||
                            (mode == RenderMode::minimum && intensity < pointed->intensity);
        if (chosen) pointed = PointedSample{intensity, 0.0, pane.volume->geometry().gridMmFromVoxel(sample.voxel)};
        sum += intensity * sample.length;
        steps += sample.length;
    }
    if (!pointed) return std::nullopt;
    if (mode == RenderMode::mean) pointed->intensity = sum / steps;
    pointed->opacity = opacityOf(pane, pane.volume->geometry().voxelFromGridMm(pointed->gridMm), pointed->intensity);
    return pointed;
}

}  // namespace

std::optional<PointedSample> samplePointedAt(const PaneRequest& pane, const RayCastSettings& settings, double x,
                                             double y) {
    if (!pane.volume) return std::nullopt;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    if (column < 0 || column >= settings.width || row < 0 || row >= settings.height) return std::nullopt;
    const std::vector<RaySample> ray = samplesAlongRay(*pane.volume, settings, column, row);
    return settings.mode == RenderMode::direct ? sampleByOpacity(pane, settings, ray)
                                               : sampleByIntensity(pane, settings, ray);
}

std::optional<double> measuredAt(const Volume& volume, const Vec3& gridMm) {
    return VolumeSampler(volume, Interpolation::trilinear).intensityAt(volume.geometry().voxelFromGridMm(gridMm));
}

}  // namespace echolucent
