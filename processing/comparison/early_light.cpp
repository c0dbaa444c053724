#include "processing/comparison/early_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "processing/comparison/surface_samples.h"
#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::size_t raysOfPart = 64;

std::size_t binOf(double intensity) {
    const double place = std::clamp(intensity, 0.0, 1.0) * EarlyLight::bins;
    return std::min(static_cast<std::size_t>(place), EarlyLight::bins - 1);
}

/// Adds what a ray holds back early.
void add(const SurfaceSamples& ray, const OpacityTable& table, EarlyLight& light) {
    ++light.rays;
    if (shownSurfaceOf(ray, table) != ShownSurface::early) return;
    ++light.early;
    const RaySamples& samples = ray.samples;
    double transmittance = 1.0;
    for (std::size_t i = 0; i < samples.intensities.size(); ++i) {
        if (ray.firstBehind + static_cast<double>(i) >= -rightUnits) return;
        const double intensity = samples.intensities[i];
        if (std::isnan(intensity)) continue;
        const double opacity = table.at(intensity, samples.gradients.empty() ? 0.0 : samples.gradients[i]);
        light.held[binOf(intensity)] += transmittance * opacity;
        transmittance *= 1.0 - opacity;
    }
}

}  // namespace

double EarlyLight::sum() const { return std::accumulate(held.begin(), held.end(), 0.0); }

std::optional<EarlyLight> earlyLightOf(const Volume& shown, const Viewpoint& view, std::span<const SurfaceRay> rays,
                                       const Classification& classification, const Progress& progress) {
    const OpacityTable table(classification);
    const SurfaceSampler sampler(shown, view, table.isTwoDimensional());
    // Parts of fixed length are summed in one order, so that any number of threads gives the same bits.
    std::vector<EarlyLight> parts((rays.size() + raysOfPart - 1) / raysOfPart);
    parallelFor(std::size_t{0}, parts.size(), [&](std::size_t part) {
        const std::size_t last = std::min(rays.size(), (part + 1) * raysOfPart);
        for (std::size_t r = part * raysOfPart; r < last && !progress.cancelled(); ++r)
            add(sampler.along(rays[r]), table, parts[part]);
    });
    if (progress.cancelled()) return std::nullopt;
    EarlyLight all;
    for (const EarlyLight& part : parts) {
        all.rays += part.rays;
        all.early += part.early;
        for (std::size_t bin = 0; bin < EarlyLight::bins; ++bin) all.held[bin] += part.held[bin];
    }
    for (double& held : all.held) held /= std::max(1, all.rays);
    return all;
}

}  // namespace echolucent
