#include "processing/speckle_reduction/shown_range.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace echolucent {

namespace {

template <typename Voxel>
StoredBounds boundsOf(const VoxelArray<Voxel>& voxels, const std::uint8_t* mask) {
    Voxel lowest = std::numeric_limits<Voxel>::max(), highest = std::numeric_limits<Voxel>::lowest();
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (mask != nullptr && mask[i] == 0) continue;
        lowest = std::min(lowest, voxels[i]);
        highest = std::max(highest, voxels[i]);
    }
    if (lowest > highest) return {};
    return {static_cast<double>(lowest), static_cast<double>(highest)};
}

/// The usual case: it needs no pass over the voxels.
bool isBytesBelowWhite(const Volume& volume) {
    return std::holds_alternative<VoxelArray<std::uint8_t>>(volume.voxels()) && volume.whiteLevel() >= 255.0;
}

}  // namespace

StoredBounds storedBounds(const Volume& volume) {
    if (isBytesBelowWhite(volume)) return {0.0, 255.0};
    return std::visit([&](const auto& voxels) { return boundsOf(voxels, volume.dataMaskOrNull()); }, volume.voxels());
}

Volume withinWhite(const Volume& volume) {
    if (isBytesBelowWhite(volume)) return volume;
    const StoredBounds bounds = storedBounds(volume);
    if (bounds.lowest >= 0.0 && bounds.highest <= volume.whiteLevel()) return volume;
    Voxels within = std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& given) -> Voxels {
            std::vector<Voxel> voxels = given.toVector();
            const auto white = static_cast<Voxel>(
                std::min(volume.whiteLevel(), static_cast<double>(std::numeric_limits<Voxel>::max())));
            for (std::size_t i = 0; i < voxels.size(); ++i)
                if (volume.hasData(static_cast<std::int64_t>(i))) voxels[i] = std::clamp(voxels[i], Voxel{0}, white);
            return voxels;
        },
        volume.voxels());
    return Volume(volume.geometry(), std::move(within), volume.whiteLevel())
        .withValueScale(volume.valueScale())
        .withDataMask(volume.dataMask());
}

}  // namespace echolucent
