#include "processing/near_cut/bright_face.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "processing/parallel.h"
#include "processing/sampling/sampler.h"

namespace echolucent {

namespace {

/// What a ray shows and how opaque it gets.
struct ShownOnRay {
    double intensity = 0.0, opacity = 0.0;
};

/// `step` is the way from sample to sample, in grid mm, `units` its length.
ShownOnRay shownOnRay(const VolumeSampler& sampler, const VolumeGeometry& geometry,
                      const std::optional<CutSurface>& front, Vec3 place, const Vec3& step, double units,
                      double steps) {
    constexpr double ended = 0.02;
    ShownOnRay shown;
    double left = 1.0;
    for (double i = 0.5; i < steps && left > ended; ++i) {
        const Vec3 here = place + step * i;
        if (front && front->cutsAway(here)) continue;
        const Vec3 voxel = geometry.voxelFromGridMm(here);
        if (!inBox(geometry, voxel)) continue;
        const double intensity = sampler.intensityAt(voxel).value_or(0.0);
        const double opacity = 1.0 - std::pow(1.0 - intensity * intensity, units);
        shown.intensity += left * opacity * intensity;
        left *= 1.0 - opacity;
    }
    shown.opacity = 1.0 - left;
    return shown;
}

}  // namespace

std::optional<double> faceIntensity(const Volume& volume, const Viewpoint& view, const Progress& progress) {
    constexpr int raysAcross = 32;
    constexpr double mostSteps = 4096.0;
    const VolumeGeometry& geometry = volume.geometry();
    const ViewFrame frame = frameOf(view);
    const auto across = geometry.depthsAlong(frame.right), down = geometry.depthsAlong(frame.down),
               along = geometry.depthsAlong(frame.forward);
    const double begin = nearPlaneDepthMm(view, geometry), unit = geometry.unit();
    const double step = std::max(unit, (along.farthest - begin) / mostSteps);
    const VolumeSampler sampler(volume);
    std::vector<ShownOnRay> rays(static_cast<std::size_t>(raysAcross) * raysAcross);
    parallelFor(0, raysAcross, [&](int row) {
        const auto between = [](const auto& range, int i) {
            return range.nearest + (i + 0.5) / raysAcross * (range.farthest - range.nearest);
        };
        for (int column = 0; column < raysAcross && !progress.cancelled(); ++column)
            rays[static_cast<std::size_t>(row * raysAcross + column)] = shownOnRay(
                sampler, geometry, view.cutSurface,
                frame.right * between(across, column) + frame.down * between(down, row) + frame.forward * begin,
                frame.forward * step, step / unit, (along.farthest - begin) / step);
    });
    if (progress.cancelled()) return std::nullopt;
    std::vector<double> shown;
    for (const ShownOnRay& ray : rays)
        if (ray.opacity >= 0.5) shown.push_back(ray.intensity);
    if (shown.empty()) return 0.0;
    const auto middle = shown.begin() + static_cast<std::ptrdiff_t>(shown.size() / 2);
    std::nth_element(shown.begin(), middle, shown.end());
    return *middle;
}

double exposureFor(double faceIntensity) {
    return faceIntensity > mostFaceIntensity ? calmFaceIntensity / faceIntensity : 1.0;
}

}  // namespace echolucent
