#include "processing/comparison/surface_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "processing/comparison/line_samples.h"
#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr double unitsBefore = 2.0, unitsBehind = 6.0;  // the light from here is the surface's
constexpr double levels = 255.0;
/// At most a hundred millionth of white can still come through, less than any figure shows.
constexpr double leastTransmittance = 1e-8;

/// Light of one ray, levels of 255.
struct RayLight {
    double surface = 0.0, rest = 0.0;
};

/// The lattice of the picture's rays: one unit apart, half a unit inside the box's outermost corner, like the ray
/// caster's samples. In a view along a grid axis they pass through voxel centres, if voxels are cubes.
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

/// The depth of the ray's first interface within what is left of it, if it leads into `into`.
std::optional<double> surfaceDepth(const PhantomTruth& truth, const Vec3& pointMm, const Vec3& forward,
                                   const DepthRange& left, double unit, InterfaceInto into) {
    // Far enough behind the boundary to be certainly behind it, and near enough to be in what it bounds.
    constexpr double justBehind = 1e-3;  // units
    const auto surface = truth.firstInterfacePoint(pointMm, forward, left.from);
    if (!surface || forward.dot(*surface) > left.to) return std::nullopt;
    if (into == InterfaceInto::object &&
        truth.materialAt(*surface + forward * (justBehind * unit)) != PhantomMaterial::object)
        return std::nullopt;
    return forward.dot(*surface);
}

/// The samples of a ray and the depth of the first. Flat front, box and the ray's shown range limit them.
class SampledRay {
public:
    /// `nearPlane` is nearPlaneDepthMm() of the view that looks along `forward`.
    SampledRay(const RaySampler& sampler, const SurfaceRay& ray, const Vec3& forward, double nearPlane,
               const LeftByFront& leftByFront)
        : m_surfaceDepth(ray.surfaceDepthMm), m_unit(sampler.volume().geometry().unit()) {
        const VolumeGeometry& geometry = sampler.volume().geometry();
        const auto span = spanInBox(geometry, ray.pointMm, forward);
        const auto left = leftByFront.of(ray.pointMm);
        if (!span || !left) return;
        constexpr double rounding = 1e-9;  // units
        const double pointDepth = forward.dot(ray.pointMm);
        const double from = std::max({pointDepth + span->from, ray.fromDepthMm, left->from});
        const double to = std::min({pointDepth + span->to, ray.toDepthMm, left->to});
        // Samples lie in the middle of steps counted from the near plane.
        const double first = std::max(0.0, std::ceil((from - nearPlane) / m_unit - 0.5 - rounding));
        const double last = std::floor((to - nearPlane) / m_unit - 0.5 + rounding);
        if (last < first) return;
        m_firstDepth = nearPlane + (first + 0.5) * m_unit;
        const Vec3 firstMm = ray.pointMm + forward * (m_firstDepth - pointDepth);
        m_samples = sampler.along(geometry.voxelFromGridMm(firstMm), geometry.voxelFromGridMm(forward * m_unit),
                                  static_cast<std::size_t>(last - first) + 1);
    }

    [[nodiscard]] RayLight lightOf(const OpacityTable& table) const {
        RayLight light;
        compositeAlong(m_samples, table, leastTransmittance, [&](std::size_t i, double contribution) {
            const double behind = (m_firstDepth - m_surfaceDepth) / m_unit + static_cast<double>(i);
            const bool ofSurface = behind >= -unitsBefore && behind <= unitsBehind;
            (ofSurface ? light.surface : light.rest) += contribution * levels;
        });
        return light;
    }

private:
    double m_surfaceDepth, m_unit;
    double m_firstDepth = 0.0;  ///< mm along forward
    RaySamples m_samples;
};

/// The contrast of every stride-th value from `first` on.
SurfaceContrast contrastOf(const std::vector<RayLight>& lights, std::size_t first, std::size_t stride) {
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

std::vector<SurfaceRay> objectRays(const VolumeGeometry& geometry, const PhantomTruth& truth, const Viewpoint& view,
                                   InterfaceInto into) {
    const ViewFrame frame = frameOf(view);
    const RayLattice lattice(geometry, frame);
    const LeftByFront leftByFront(view, geometry);
    const double unit = geometry.unit();
    std::vector<std::vector<SurfaceRay>> ofRow(static_cast<std::size_t>(lattice.rows));
    parallelFor(0, lattice.rows, [&](int row) {
        for (int column = 0; column < lattice.columns; ++column) {
            const Vec3 point =
                frame.right * (lattice.firstRight + column * unit) + frame.down * (lattice.firstDown + row * unit);
            const auto left = leftByFront.of(point);
            if (!left) continue;
            if (const auto depth = surfaceDepth(truth, point, frame.forward, *left, unit, into))
                ofRow[static_cast<std::size_t>(row)].push_back({.pointMm = point, .surfaceDepthMm = *depth});
        }
    });
    std::vector<SurfaceRay> rays;
    for (const auto& row : ofRow) rays.insert(rays.end(), row.begin(), row.end());
    return rays;
}

std::vector<SurfaceContrast> surfaceContrasts(const Volume& volume, std::span<const SurfaceRay> rays,
                                              const Viewpoint& view, std::span<const Classification> classifications) {
    const std::vector<OpacityTable> tables = tablesOf(classifications);
    return surfaceContrasts(RaySampler(volume, anyTwoDimensional(tables)), rays, view, tables);
}

std::vector<SurfaceContrast> surfaceContrasts(const RaySampler& sampler, std::span<const SurfaceRay> rays,
                                              const Viewpoint& view, std::span<const OpacityTable> tables) {
    const VolumeGeometry& geometry = sampler.volume().geometry();
    const Vec3 forward = frameOf(view).forward;
    const double nearPlane = nearPlaneDepthMm(view, geometry);
    const LeftByFront leftByFront(view, geometry);
    std::vector<RayLight> lights(rays.size() * tables.size());
    parallelFor(LoopRange<std::size_t>(0, rays.size(), 64), [&](const auto& some) {
        for (std::size_t r = some.begin(); r < some.end(); ++r) {
            const SampledRay ray(sampler, rays[r], forward, nearPlane, leftByFront);
            for (std::size_t c = 0; c < tables.size(); ++c) lights[r * tables.size() + c] = ray.lightOf(tables[c]);
        }
    });
    // Each ray has its place, and sums have one order, so that any number of threads gives the same bits.
    std::vector<SurfaceContrast> contrasts;
    for (std::size_t c = 0; c < tables.size(); ++c) contrasts.push_back(contrastOf(lights, c, tables.size()));
    return contrasts;
}

std::vector<SurfaceContrast> surfaceContrasts(const Volume& volume, std::span<const SurfaceRay> rays,
                                              const Viewpoint& view, std::span<const OpacityCurve> curves) {
    const std::vector<Classification> classifications(curves.begin(), curves.end());
    return surfaceContrasts(volume, rays, view, classifications);
}

}  // namespace echolucent
