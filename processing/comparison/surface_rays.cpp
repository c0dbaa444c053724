#include "processing/comparison/surface_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/halved_lengths.h"
#include "processing/adaptive/method_reading.h"
#include "processing/parallel.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/viewpoint/shown_stretch.h"

namespace echolucent {

namespace {

/// The lattice of the picture's rays: one unit or more apart, half a unit inside the box's outermost corner, like the
/// ray caster's samples. In a view along a grid axis they pass through voxel centres, if voxels are cubes and the
/// spacing is whole.
struct RayLattice {
    double firstRight, firstDown;
    double spacingMm;
    int columns, rows;

    RayLattice(const VolumeGeometry& geometry, const ViewFrame& frame, double raySpacing)
        : spacingMm(raySpacing * geometry.unit()) {
        const auto [leastRight, mostRight] = extent(geometry, frame.right);
        const auto [leastDown, mostDown] = extent(geometry, frame.down);
        const double inside = 0.5 * geometry.unit();
        const auto count = [&](double width) {
            return std::max(1, static_cast<int>(std::ceil(width / spacingMm - 1e-6)));
        };
        firstRight = leastRight + inside;
        firstDown = leastDown + inside;
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

/// The depth of the ray's first interface within what is shown of it, if it leads into `into`.
std::optional<double> surfaceDepth(const PhantomTruth& truth, const Vec3& pointMm, const Vec3& forward,
                                   const CutSurface::Stretch& shown, double unit, InterfaceInto into) {
    // Far enough behind the boundary to be certainly behind it, and near enough to be in what it bounds.
    constexpr double justBehind = 1e-3;  // units
    const double pointDepth = forward.dot(pointMm);
    const auto surface = truth.firstInterfacePoint(pointMm, forward, pointDepth + shown.begin);
    if (!surface || forward.dot(*surface) > pointDepth + shown.end) return std::nullopt;
    const bool object = truth.materialAt(*surface + forward * (justBehind * unit)) == PhantomMaterial::object;
    if (into == (object ? InterfaceInto::tissue : InterfaceInto::object)) return std::nullopt;
    return forward.dot(*surface);
}

}  // namespace

std::vector<SurfaceRay> trueSurfaces(const VolumeGeometry& geometry, const PhantomTruth& truth, const Viewpoint& view,
                                     InterfaceInto into, double raySpacing, const Progress& progress) {
    if (!(std::isfinite(raySpacing) && raySpacing > 0.0))
        throw std::invalid_argument("trueSurfaces: the ray spacing must be above 0");
    const ViewFrame frame = frameOf(view);
    const RayLattice lattice(geometry, frame, raySpacing);
    const ShownStretches shown(view, geometry);
    const double unit = geometry.unit();
    std::vector<std::vector<SurfaceRay>> ofRow(static_cast<std::size_t>(lattice.rows));
    parallelFor(0, lattice.rows, [&](int row) {
        for (int column = 0; column < lattice.columns && !progress.cancelled(); ++column) {
            const Vec3 point = frame.right * (lattice.firstRight + column * lattice.spacingMm) +
                               frame.down * (lattice.firstDown + row * lattice.spacingMm);
            const auto stretch = shown.of(point);
            if (!stretch) continue;
            if (const auto depth = surfaceDepth(truth, point, frame.forward, *stretch, unit, into))
                ofRow[static_cast<std::size_t>(row)].push_back({.pointMm = point, .surfaceDepthMm = *depth});
        }
    });
    std::vector<SurfaceRay> rays;
    for (const auto& row : ofRow) rays.insert(rays.end(), row.begin(), row.end());
    return rays;
}

std::vector<SurfaceRay> tubeCoreRays(const VolumeGeometry& geometry, const AdaptiveOtf& otf) {
    const auto axes = tubeAxes(geometry, otf.view, otf.config.grid, configUsed(otf).cells.size);
    std::vector<SurfaceRay> rays;
    for (std::size_t t = 0; t < otf.tubes.size() && t < axes.size(); ++t) {
        const TubeCore& tube = otf.tubes[t];
        if (!tube.surfaceVoxel || !(tube.d > 0.0) || !axes[t].entryVoxel) continue;
        rays.push_back({axes[t].pointMm, axes[t].directionMm.dot(geometry.gridMmFromVoxel(*tube.surfaceVoxel))});
    }
    return rays;
}

std::optional<std::vector<SurfaceRay>> foundSurfaces(const Volume& raw, const Viewpoint& view,
                                                     const Progress& progress) {
    auto found = spacedSurfaces(raw, view, progress);
    return found ? std::optional(std::move(found->rays)) : std::nullopt;
}

std::optional<SpacedSurfaces> spacedSurfaces(const Volume& raw, const Viewpoint& view, const Progress& progress) {
    AdaptiveOtfConfig config = configOf(MethodReading::firstVersion);
    config.grid = {.columns = measuredTubesAcross, .rows = measuredTubesAcross};
    const auto otf = adaptOpacity(raw, view, config, progress);
    if (!otf) return std::nullopt;
    // Where the data begin is no surface that anybody wants to see.
    if (otf->surfacesWhereDataBegin) return SpacedSurfaces{};
    return SpacedSurfaces{tubeCoreRays(raw.geometry(), *otf), otf->tubeSpacingUnits};
}

}  // namespace echolucent
