#include "app/measuring/measures/surface_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/measuring/measures/line_samples.h"
#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr double unitsBefore = 2.0, unitsBehind = 6.0;  // what counts as the true surface's light
constexpr double levels = 255.0;
/// A hundred millionth of white can still come through, which is less than any figure shows.
constexpr double leastTransmittance = 1e-8;

/// Light of one ray, levels of 255.
struct RayLight {
    double surface = 0.0, rest = 0.0;
};

/// The lattice of the picture's rays: one unit apart, half a unit inside the box's outermost corner, as the ray caster
/// puts its samples: on a view along a grid axis they pass through voxel centres.
struct RayLattice {
    double firstRight, firstDown;
    int columns, rows;

    RayLattice(const VolumeGeometry& geometry, const ViewFrame& frame) {
        const auto [leastRight, mostRight] = extent(geometry, frame.right);
        const auto [leastDown, mostDown] = extent(geometry, frame.down);
        const double unit = geometry.unit();
        const auto count = [&](double width) { return std::max(1, static_cast<int>(std::ceil(width / unit - 1e-6))); };
        firstRight = leastRight + 0.5 * unit;
        firstDown = leastDown + 0.5 * unit;
        columns = count(mostRight - leastRight);
        rows = count(mostDown - leastDown);
    }

private:
    static std::array<double, 2> extent(const VolumeGeometry& geometry, const Vec3& direction) {
        std::array<double, 2> range{0.0, 0.0};
        for (int axis = 0; axis < 3; ++axis) {
            const double a = direction[axis] * geometry.boxMinMm()[axis];
            const double b = direction[axis] * geometry.boxMaxMm()[axis];
            range[0] += std::min(a, b);
            range[1] += std::max(a, b);
        }
        return range;
    }
};

/// The depth of the ray's first interface where that leads into what is asked for.
std::optional<double> surfaceDepth(const PhantomTruth& truth, const Vec3& pointMm, const Vec3& forward,
                                   double nearPlane, double unit, InterfaceInto into) {
    // The place is far enough behind the boundary to be beyond the doubt about where it is, and near enough to be in
    // what it bounds.
    constexpr double justBehind = 1e-3;  // units
    const auto surface = truth.firstInterfacePoint(pointMm, forward, nearPlane);
    if (!surface) return std::nullopt;
    if (into == InterfaceInto::object &&
        truth.materialAt(*surface + forward * (justBehind * unit)) != PhantomMaterial::object)
        return std::nullopt;
    return forward.dot(*surface);
}

/// The intensities of a ray with the depth of the first, the near plane and the box respected.
class SampledRay {
public:
    SampledRay(const Volume& volume, const Vec3& pointMm, const Vec3& forward, double nearPlane) {
        const VolumeGeometry& geometry = volume.geometry();
        const auto span = spanInBox(geometry, pointMm, forward);
        if (!span) return;
        constexpr double rounding = 1e-9;  // units
        const double unit = geometry.unit(), pointDepth = forward.dot(pointMm);
        // Samples lie in the middle of steps counted from the near plane.
        const double first = std::max(0.0, std::ceil((pointDepth + span->from - nearPlane) / unit - 0.5 - rounding));
        const double last = std::floor((pointDepth + span->to - nearPlane) / unit - 0.5 + rounding);
        if (last < first) return;
        m_firstDepth = nearPlane + (first + 0.5) * unit;
        m_intensities.resize(static_cast<std::size_t>(last - first) + 1);
        const Vec3 firstMm = pointMm + forward * (m_firstDepth - pointDepth);
        sampleLine(volume, geometry.voxelFromGridMm(firstMm), geometry.voxelFromGridMm(forward * unit), m_intensities);
    }

    /// Composites front to back (eq. 3).
    [[nodiscard]] RayLight lightOf(const OpacityTable& table, double surfaceDepth, double unit) const {
        RayLight light;
        double transmittance = 1.0;
        for (std::size_t i = 0; i < m_intensities.size() && transmittance > leastTransmittance; ++i) {
            const double intensity = m_intensities[i];
            if (std::isnan(intensity)) continue;
            const double opacity = table.at(intensity);
            const double behind = (m_firstDepth - surfaceDepth) / unit + static_cast<double>(i);
            const bool ofSurface = behind >= -unitsBefore && behind <= unitsBehind;
            (ofSurface ? light.surface : light.rest) += transmittance * opacity * intensity * levels;
            transmittance *= 1.0 - opacity;
        }
        return light;
    }

private:
    double m_firstDepth = 0.0;  ///< mm along forward
    std::vector<double> m_intensities;
};

/// Every stride-th value from `first` on.
SurfaceContrast summedUp(const std::vector<RayLight>& lights, std::size_t first, std::size_t stride) {
    SurfaceContrast contrast;
    for (std::size_t i = first; i < lights.size(); i += stride) {
        ++contrast.rays;
        contrast.meanSurface += lights[i].surface;
        contrast.meanRest += lights[i].rest;
    }
    if (contrast.rays == 0) return contrast;
    contrast.meanSurface /= contrast.rays;
    contrast.meanRest /= contrast.rays;
    for (std::size_t i = first; i < lights.size(); i += stride) {
        contrast.varianceSurface += std::pow(lights[i].surface - contrast.meanSurface, 2);
        contrast.varianceRest += std::pow(lights[i].rest - contrast.meanRest, 2);
    }
    contrast.varianceSurface /= contrast.rays;
    contrast.varianceRest /= contrast.rays;
    return contrast;
}

}  // namespace

std::optional<double> SurfaceContrast::contrastToNoise() const {
    const double variance = varianceSurface + varianceRest;
    if (rays == 0 || !(variance > 0)) return std::nullopt;
    return (meanSurface - meanRest) / std::sqrt(variance);
}

std::vector<ObjectRay> objectRays(const VolumeGeometry& geometry, const PhantomTruth& truth, const Viewpoint& view,
                                  InterfaceInto into) {
    const ViewFrame frame = frameOf(view);
    const RayLattice lattice(geometry, frame);
    const double nearPlane = nearPlaneDepthMm(view, geometry), unit = geometry.unit();
    std::vector<std::vector<ObjectRay>> ofRow(static_cast<std::size_t>(lattice.rows));
    parallelFor(0, lattice.rows, [&](int row) {
        for (int column = 0; column < lattice.columns; ++column) {
            const Vec3 point =
                frame.right * (lattice.firstRight + column * unit) + frame.down * (lattice.firstDown + row * unit);
            if (const auto depth = surfaceDepth(truth, point, frame.forward, nearPlane, unit, into))
                ofRow[static_cast<std::size_t>(row)].push_back({point, *depth});
        }
    });
    std::vector<ObjectRay> rays;
    for (const auto& row : ofRow) rays.insert(rays.end(), row.begin(), row.end());
    return rays;
}

std::vector<SurfaceContrast> surfaceContrasts(const Volume& volume, std::span<const ObjectRay> rays,
                                              const Viewpoint& view, std::span<const OpacityCurve> curves) {
    std::vector<OpacityTable> tables;
    for (const OpacityCurve& curve : curves) tables.emplace_back(curve);
    const Vec3 forward = frameOf(view).forward;
    const double nearPlane = nearPlaneDepthMm(view, volume.geometry()), unit = volume.geometry().unit();
    std::vector<RayLight> lights(rays.size() * tables.size());
    parallelFor(tbb::blocked_range<std::size_t>(0, rays.size(), 64), [&](const auto& some) {
        for (std::size_t r = some.begin(); r < some.end(); ++r) {
            const SampledRay ray(volume, rays[r].pointMm, forward, nearPlane);
            for (std::size_t c = 0; c < tables.size(); ++c)
                lights[r * tables.size() + c] = ray.lightOf(tables[c], rays[r].surfaceDepthMm, unit);
        }
    });
    // Each ray has its place and the sums are made in one order, so that any number of threads gives the same bits.
    std::vector<SurfaceContrast> contrasts;
    for (std::size_t c = 0; c < tables.size(); ++c) contrasts.push_back(summedUp(lights, c, tables.size()));
    return contrasts;
}

SurfaceContrast surfaceContrast(const Volume& volume, const PhantomTruth& truth, const Viewpoint& view,
                                const OpacityCurve& curve) {
    return surfaceContrasts(volume, objectRays(volume.geometry(), truth, view), view, {&curve, 1}).front();
}

}  // namespace echolucent
