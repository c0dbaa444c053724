#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "processing/ray_caster/ray_kernel.h"

namespace echolucent {

namespace {

using namespace ray_casting;

constexpr int tileEdge = 32;

/// Which voxels beyond a sample's cell its gradient reads.
std::array<int, 3> gradientReach(const Volume& volume, const std::optional<Shading>& shading) {
    std::array<int, 3> reach{0, 0, 0};
    if (!shading) return reach;
    const VolumeGeometry& geometry = volume.geometry();
    for (int axis = 0; axis < 3; ++axis)
        reach[static_cast<std::size_t>(axis)] =
            static_cast<int>(std::ceil(shading->gradientReach * geometry.unit() / geometry.spacing[axis]));
    return reach;
}

/// Reports from the calling thread only; counts for all.
class TileCount {
public:
    TileCount(const Progress& progress, int tiles) : m_progress(progress), m_tiles(tiles) {}
    void oneDone() {
        const int done = m_done.fetch_add(1, std::memory_order_relaxed) + 1;
        if (std::this_thread::get_id() == m_caller) m_progress.at(static_cast<double>(done) / m_tiles);
    }

private:
    const Progress& m_progress;
    int m_tiles;
    std::thread::id m_caller = std::this_thread::get_id();
    std::atomic<int> m_done{0};
};

template <typename Kernel>
void castTile(const Kernel& kernel, const RayGeometry& rays, int tileColumn, int tileRow, Picture& picture) {
    const int lastColumn = std::min((tileColumn + 1) * tileEdge, picture.width);
    const int lastRow = std::min((tileRow + 1) * tileEdge, picture.height);
    for (int row = tileRow * tileEdge; row < lastRow; ++row)
        for (int column = tileColumn * tileEdge; column < lastColumn; ++column) {
            const Ray ray = rays.rayThrough(column, row);
            if (ray.first >= ray.last) continue;
            const Float4 colour = kernel.cast(ray);
            float* pixel = &picture.rgba[(static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                          static_cast<std::size_t>(column)) *
                                         4];
            // Sums of rounded shares may end a hair above 1.
            for (int channel = 0; channel < 4; ++channel) pixel[channel] = std::min(colour[channel], 1.0f);
        }
}

template <typename Kernel>
std::optional<Picture> castTiles(const Kernel& kernel, const RayGeometry& rays, const RayCastSettings& settings,
                                 const Progress& progress) {
    Picture picture{settings.width, settings.height, {}, {}};
    picture.rgba.assign(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height) * 4, 0.0f);
    const int columns = (settings.width + tileEdge - 1) / tileEdge, rows = (settings.height + tileEdge - 1) / tileEdge;
    TileCount count(progress, columns * rows);
    tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1), [&](const auto& tiles) {
        for (int row = tiles.rows().begin(); row < tiles.rows().end(); ++row)
            for (int column = tiles.cols().begin(); column < tiles.cols().end(); ++column) {
                if (progress.cancelled()) return;
                castTile(kernel, rays, column, row, picture);
                count.oneDone();
            }
    });
    if (progress.cancelled()) return std::nullopt;
    return picture;
}

template <typename Voxel, Interpolation interpolation>
std::optional<Picture> castVoxels(const Volume& volume, const TransferTable& table, const RayCastSettings& settings,
                                  const Progress& progress) {
    const RayGeometry rays(volume.geometry(), settings);
    const BrickMap bricks(volume, table, gradientReach(volume, settings.shading));
    if (settings.shading)
        return castTiles(RayKernel<Voxel, interpolation, true>(volume, table, bricks, settings), rays, settings,
                         progress);
    return castTiles(RayKernel<Voxel, interpolation, false>(volume, table, bricks, settings), rays, settings, progress);
}

}  // namespace

std::optional<Picture> castRays(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                                const Progress& progress) {
    if (!std::isfinite(settings.step) || !(settings.step > 0.0))
        throw std::invalid_argument("castRays: the step must be finite and above 0");
    if (settings.shading && !(settings.shading->gradientReach > 0.0))
        throw std::invalid_argument("castRays: the gradient's reach must be above 0");
    const TransferTable table(curve, settings.colourMap, settings.step);
    return std::visit(
        [&]<typename Voxel>(const std::vector<Voxel>&) {
            return settings.interpolation == Interpolation::nearest
                       ? castVoxels<Voxel, Interpolation::nearest>(volume, table, settings, progress)
                       : castVoxels<Voxel, Interpolation::trilinear>(volume, table, settings, progress);
        },
        volume.voxels());
}

}  // namespace echolucent
