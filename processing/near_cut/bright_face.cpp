#include "processing/near_cut/bright_face.h"

#include <algorithm>
#include <vector>

#include "processing/parallel.h"
#include "processing/sampling/sampler.h"

namespace echolucent {

namespace {

/// What a ray shows and how opaque it gets.
struct ShownOnRay {
    double intensity = 0.0, opacity = 0.0;
};

/// `step` is a unit along the view, in grid mm.
ShownOnRay shownOnRay(const VolumeSampler& sampler, const VolumeGeometry& geometry, Vec3 place, const Vec3& step,
                      double steps) {
    constexpr double ended = 0.02;
    ShownOnRay shown;
    double left = 1.0;
    for (double i = 0.5; i < steps && left > ended; ++i) {
        const Vec3 voxel = geometry.voxelFromGridMm(place + step * i);
        if (!inBox(geometry, voxel)) continue;
        const double intensity = sampler.intensityAt(voxel).value_or(0.0);
        const double opacity = intensity * intensity;
        shown.intensity += left * opacity * intensity;
        left *= 1.0 - opacity;
    }
    shown.opacity = 1.0 - left;
    return shown;
}

}  // namespace

double faceIntensity(const Volume& volume, const Viewpoint& view) {
    constexpr int raysAcross = 32;
    const VolumeGeometry& geometry = volume.geometry();
    const ViewFrame frame = frameOf(view);
    const auto across = geometry.depthsAlong(frame.right), down = geometry.depthsAlong(frame.down),
               along = geometry.depthsAlong(frame.forward);
    const double begin = nearPlaneDepthMm(view, geometry), unit = geometry.unit();
    const VolumeSampler sampler(volume);
    std::vector<ShownOnRay> rays(static_cast<std::size_t>(raysAcross) * raysAcross);
    parallelFor(0, raysAcross, [&](int row) {
        const auto between = [](const auto& range, int i) {
            return range.nearest + (i + 0.5) / raysAcross * (range.farthest - range.nearest);
        };
        for (int column = 0; column < raysAcross; ++column)
            rays[static_cast<std::size_t>(row * raysAcross + column)] = shownOnRay(
                sampler, geometry,
                frame.right * between(across, column) + frame.down * between(down, row) + frame.forward * begin,
                frame.forward * unit, (along.farthest - begin) / unit);
    });
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
