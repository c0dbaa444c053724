#include "processing/speckle_reduction/filter_slabs.h"

#include <algorithm>
#include <span>
#include <utility>

#include "processing/parallel.h"

namespace echolucent {

std::vector<FilterSlab> filterSlabs(const VolumeGeometry& geometry, std::int64_t reach, std::int64_t mostVoxels) {
    const std::int64_t slices = geometry.size[2];
    if (geometry.voxelCount() <= mostVoxels) return {{0, slices, 0, slices}};
    const std::int64_t fitting = mostVoxels / (geometry.size[0] * geometry.size[1]) - 2 * reach;
    const std::int64_t thickness = std::max({std::int64_t{2}, reach, fitting});
    std::vector<FilterSlab> slabs;
    for (std::int64_t first = 0; first < slices; first += thickness) {
        const std::int64_t end = std::min(slices, first + thickness);
        slabs.push_back({first, end, std::max<std::int64_t>(0, first - reach), std::min(slices, end + reach)});
    }
    return slabs;
}

Volume intensitiesOf(const Volume& volume, const FilterSlab& slab) {
    VolumeGeometry geometry = volume.geometry();
    const std::int64_t slice = geometry.size[0] * geometry.size[1];
    const std::int64_t from = slab.firstHeld * slice;
    geometry.size[2] = slab.endHeld - slab.firstHeld;
    std::vector<float> floats(static_cast<std::size_t>(geometry.voxelCount()));
    const double white = volume.whiteLevel();
    std::visit(
        [&](const auto& voxels) {
            parallelFor<std::int64_t>(0, geometry.size[2], [&](std::int64_t z) {
                for (std::int64_t i = z * slice; i < (z + 1) * slice; ++i)
                    if (volume.hasData(from + i))
                        floats[static_cast<std::size_t>(i)] = static_cast<float>(std::clamp(
                            static_cast<double>(voxels[static_cast<std::size_t>(from + i)]) / white, 0.0, 1.0));
            });
        },
        volume.voxels());
    // What the grid says of a probe or a reduction is of no matter to a filter.
    geometry.probe.reset();
    geometry.reduction.reset();
    Volume intensities(geometry, std::move(floats), 1.0);
    if (volume.dataMask().empty()) return intensities;
    const std::span held(volume.dataMask().data() + from, static_cast<std::size_t>(geometry.voxelCount()));
    return intensities.withDataMask(std::vector<std::uint8_t>(held.begin(), held.end()));
}

}  // namespace echolucent
