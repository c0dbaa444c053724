#include "processing/volume/coarse_grid.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace echolucent {

namespace {

/// The values at the voxels of the coarse grid. `values` holds one value for each voxel of the volume, and is not
/// empty.
template <typename Value>
std::vector<Value> taken(const CoarseGrid& grid, std::span<const Value> values) {
    std::vector<Value> few;
    few.reserve(static_cast<std::size_t>(grid.geometry.voxelCount()));
    const auto& size = grid.geometry.size;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y) {
            const std::int64_t row = grid.full.offset(0, grid.voxelOf(1, y), grid.voxelOf(2, z));
            for (std::int64_t x = 0; x < size[0]; ++x)
                few.push_back(values[static_cast<std::size_t>(row + grid.voxelOf(0, x))]);
        }
    return few;
}

}  // namespace

DataBox CoarseGrid::boxOfVolume() const {
    const Vec3 shift = full.gridMmFromVoxel(
        Vec3(static_cast<double>(first[0]), static_cast<double>(first[1]), static_cast<double>(first[2])));
    return {full.boxMinMm() - shift, full.boxMaxMm() - shift};
}

std::optional<CoarseGrid> coarseGridOf(const VolumeGeometry& volume) {
    if (volume.voxelCount() < leastVoxelsForCoarse) return std::nullopt;
    const DataBox whole(volume);
    const double longest = std::max({whole.sizeMm()[0], whole.sizeMm()[1], whole.sizeMm()[2]});
    CoarseGrid grid{.full = volume, .geometry = volume};
    for (int axis = 0; axis < 3; ++axis) {
        const auto of = static_cast<std::size_t>(axis);
        const double voxels = longest / (static_cast<double>(mostCoarseVoxels) * volume.spacing[axis]);
        constexpr double rounding = 1e-9;  // 512 voxels of 0.3 mm must not count as longer than 128 of 1.2 mm
        const auto asCubes = static_cast<std::int64_t>(std::ceil(voxels * (1.0 - rounding)));
        grid.stride[of] = std::clamp<std::int64_t>(asCubes, 1, volume.size[of]);
        grid.first[of] = (grid.stride[of] - 1) / 2;
        grid.geometry.size[of] = (volume.size[of] - grid.first[of] + grid.stride[of] - 1) / grid.stride[of];
        grid.geometry.spacing[axis] *= static_cast<double>(grid.stride[of]);
    }
    const Vec3 first(static_cast<double>(grid.first[0]), static_cast<double>(grid.first[1]),
                     static_cast<double>(grid.first[2]));
    grid.geometry.origin = volume.patientFromVoxel(first);
    if (auto& probe = grid.geometry.probe; probe && probe->apexMm) *probe->apexMm -= volume.gridMmFromVoxel(first);
    return grid;
}

CoarseVolume coarseVolumeOf(const CoarseGrid& grid, const Volume& voxels) {
    const DataBox whole = grid.boxOfVolume();
    const DataBox border(grid.geometry);
    DataBox box = voxels.dataBox();
    for (int axis = 0; axis < 3; ++axis) {
        const double half = 0.5 * grid.full.spacing[axis];
        box.lowMm[axis] = box.lowMm[axis] < border.lowMm[axis] + half ? whole.lowMm[axis]
                                                                      : std::max(box.lowMm[axis], whole.lowMm[axis]);
        box.highMm[axis] = box.highMm[axis] > border.highMm[axis] - half
                               ? whole.highMm[axis]
                               : std::min(box.highMm[axis], whole.highMm[axis]);
    }
    return {std::make_shared<const Volume>(voxels.withDataBox(box)), grid.geometry.unit() / grid.full.unit()};
}

std::optional<CoarseVolume> coarseVolumeOf(const Volume& volume) {
    const auto grid = coarseGridOf(volume.geometry());
    if (!grid) return std::nullopt;
    Voxels few = std::visit(
        [&](const auto& values) { return Voxels(VoxelArray(taken(*grid, std::span(values.data(), values.size())))); },
        volume.voxels());
    const Volume voxels =
        Volume(grid->geometry, std::move(few), volume.whiteLevel()).withValueScale(volume.valueScale());
    const auto& mask = volume.dataMask();
    return coarseVolumeOf(
        *grid, mask.empty() ? voxels : voxels.withDataMask(taken(*grid, std::span(mask.data(), mask.size()))));
}

}  // namespace echolucent
