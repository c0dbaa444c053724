#include "processing/volume/filled_volume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "processing/volume/bit_grid.h"
#include "processing/volume/filled_layers.h"
#include "processing/volume/grid_rows.h"
#include "processing/volume/presence.h"

namespace echolucent {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t rowsOfVoxels = 64;  ///< rows that one thread takes at a time

/// One byte for each voxel: 1 if the mask marks the voxel (an empty mask marks all) and its value is finite, else 0.
/// Empty if every byte would be 1.
template <typename Voxel>
Bytes dataOf(const VolumeGeometry& geometry, const DataMask& mask, const VoxelArray<Voxel>& voxels) {
    if (mask.empty() && !std::is_same_v<Voxel, float>) return {};
    Bytes data(voxels.size());
    forEachRow(geometry.size, rowsOfVoxels, [&](std::int64_t y, std::int64_t z) {
        const std::int64_t first = geometry.offset(0, y, z), columns = geometry.size[0];
        std::uint8_t* to = data.data() + first;
        const std::uint8_t* marks = mask.empty() ? nullptr : mask.data() + first;
        const Voxel* values = voxels.data() + first;
        for (std::int64_t x = 0; x < columns; ++x) {
            to[x] = marks == nullptr || marks[x] != 0 ? 1 : 0;
            if constexpr (std::is_same_v<Voxel, float>) to[x] &= std::isfinite(values[x]) ? 1 : 0;
        }
    });
    if (std::find(data.begin(), data.end(), 0) == data.end()) data.clear();
    return data;
}

/// The bytes of dataOf() as bits. A pass over bits is short, and most voxels need no more, because they lie far from
/// the border of the data.
BitGrid bitsOf(const VolumeGeometry& geometry, const Bytes& data) {
    BitGrid bits(geometry.size);
    forEachRow(geometry.size, rowsOfVoxels, [&](std::int64_t y, std::int64_t z) {
        const std::uint8_t* from = data.data() + geometry.offset(0, y, z);
        std::uint64_t* to = bits.row(y, z);
        std::int64_t x = 0;
        for (; x + 8 <= geometry.size[0]; x += 8) {
            std::uint64_t eight = 0;
            std::memcpy(&eight, from + x, sizeof(eight));
            // The product gathers the lowest bit of each byte in the uppermost byte; the first byte's bit comes lowest.
            to[x / 64] |= (eight * 0x0102040810204080 >> 56) << (x % 64);
        }
        for (; x < geometry.size[0]; ++x) to[x / 64] |= std::uint64_t{from[x]} << (x % 64);
    });
    return bits;
}

template <typename Voxel>
Volume filled(const Volume& volume, const VoxelArray<Voxel>& given) {
    const VolumeGeometry& geometry = volume.geometry();
    Bytes mask = dataOf(geometry, volume.scannedMask(), given);
    if (mask.empty()) return volume.withCut(nullptr);
    std::vector<Voxel> voxels = given.toVector();
    BitGrid known = bitsOf(geometry, mask);
    fillLayers<Voxel>(geometry, voxels, known, FilledVolume::fillReach,
                      [&](std::int64_t at) { mask[static_cast<std::size_t>(at)] = 1; });
    forEachRow(geometry.size, rowsOfVoxels, [&](std::int64_t y, std::int64_t z) {
        const auto first = static_cast<std::size_t>(geometry.offset(0, y, z));
        for (std::size_t i = first; i < first + static_cast<std::size_t>(geometry.size[0]); ++i)
            if (mask[i] == 0) voxels[i] = Voxel{};
    });
    return Volume(geometry, std::move(voxels), volume.whiteLevel())
        .withValueScale(volume.valueScale())
        .withDataMask(std::move(mask));
}

}  // namespace

Volume filledVoxels(const Volume& volume) {
    return std::visit([&](const auto& voxels) { return filled(volume, voxels); }, volume.voxels());
}

std::optional<Volume> presenceIn(const Volume& volume) {
    if (!lacksData(volume)) return std::nullopt;
    const VolumeGeometry& geometry = volume.geometry();
    const auto slice = static_cast<std::size_t>(geometry.size[0] * geometry.size[1]);
    Bytes presence(slice * static_cast<std::size_t>(geometry.size[2]));
    makePresence(volume, RowMarks(geometry.size, true), [&](std::int64_t z, const std::uint8_t* from) {
        std::copy_n(from, slice, presence.data() + geometry.offset(0, 0, z));
    });
    return Volume(geometry, std::move(presence), 255.0);
}

FilledVolume filledVolume(const Volume& volume) { return {filledVoxels(volume), presenceIn(volume)}; }

}  // namespace echolucent
