#include "processing/speckle_reduction/filter_slabs.h"

#include <algorithm>

namespace echolucent {

std::vector<FilterSlab> filterSlabs(const VolumeGeometry& geometry, std::int64_t reach, std::int64_t mostVoxels,
                                    std::int64_t threads) {
    const std::int64_t slices = geometry.size[2];
    if (geometry.voxelCount() <= mostVoxels) return {{0, slices, 0, slices}};
    constexpr std::int64_t share = 8;
    const std::int64_t thickness =
        std::max({reach, threads, mostVoxels / share / (geometry.size[0] * geometry.size[1])});
    std::vector<FilterSlab> slabs;
    for (std::int64_t first = 0; first < slices; first += thickness) {
        const std::int64_t end = std::min(slices, first + thickness);
        slabs.push_back({first, end, first, std::min(slices, end + reach)});
    }
    return slabs;
}

}  // namespace echolucent
