#include "processing/volume/filled_volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "processing/volume/bit_grid.h"
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

/// Offsets of the row (y, z) and of the rows around it. Where a row would lie outside the grid, the nearest row of the
/// grid stands for it.
struct RowsAround {
    const VolumeGeometry& geometry;
    std::int64_t y, z;
    [[nodiscard]] std::int64_t offset(std::int64_t downwards, std::int64_t behind) const {
        return geometry.offset(0, std::clamp<std::int64_t>(y + downwards, 0, geometry.size[1] - 1),
                               std::clamp<std::int64_t>(z + behind, 0, geometry.size[2] - 1));
    }
};

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

/// A row and the eight around it: their voxels, and bits that mark the known ones.
template <typename Voxel>
struct NineRows {
    std::array<const Voxel*, 9> voxels{};
    std::array<const std::uint64_t*, 9> known{};
    std::int64_t columns, words;

    NineRows(const VolumeGeometry& geometry, const std::vector<Voxel>& from, const BitGrid& bits, std::int64_t y,
             std::int64_t z)
        : columns(geometry.size[0]), words(bits.words()) {
        const RowsAround around{geometry, y, z};
        std::size_t row = 0;
        for (std::int64_t behind = -1; behind <= 1; ++behind)
            for (std::int64_t downwards = -1; downwards <= 1; ++downwards) {
                const std::int64_t first = around.offset(downwards, behind);
                voxels[row] = from.data() + first;
                known[row++] = bits.row(first / columns % geometry.size[1], first / columns / geometry.size[1]);
            }
    }

    /// Visits each unknown voxel of the middle row with a known voxel among the 26 around it.
    template <typename Visit>
    void forEachBesideKnown(const Visit& visit) const {
        const std::uint64_t* own = known[4];
        const auto any = [&](std::int64_t word) {
            std::uint64_t bits = 0;
            for (const std::uint64_t* row : known) bits |= row[word];
            return bits;
        };
        std::uint64_t before = 0, here = any(0);
        for (std::int64_t word = 0; word < words; ++word) {
            const std::uint64_t after = word + 1 < words ? any(word + 1) : 0;
            std::uint64_t beside = (here | here << 1 | here >> 1 | before >> 63 | after << 63) & ~own[word];
            for (; beside != 0; beside &= beside - 1) {
                const std::int64_t x = word * 64 + std::countr_zero(beside);
                if (x < columns) visit(x);
            }
            before = here;
            here = after;
        }
    }

    /// The mean of the known voxels among the 27 around place `x`; whole numbers are rounded. At least one must be
    /// known.
    [[nodiscard]] Voxel meanAround(std::int64_t x) const {
        double sum = 0.0;
        int count = 0;
        const std::int64_t first = std::max<std::int64_t>(x - 1, 0), last = std::min(x + 1, columns - 1);
        for (std::size_t row = 0; row < voxels.size(); ++row)
            for (std::int64_t i = first; i <= last; ++i) {
                if ((known[row][i / 64] >> (i % 64) & 1) == 0) continue;
                sum += static_cast<double>(voxels[row][i]);
                ++count;
            }
        const double mean = sum / count;
        if constexpr (std::is_same_v<Voxel, float>) return static_cast<float>(mean);
        return static_cast<Voxel>(std::lround(mean));
    }
};

/// Fills one more layer of voxels around the known ones.
template <typename Voxel>
void growLayer(const VolumeGeometry& geometry, std::vector<Voxel>& voxels, BitGrid& known, Bytes& mask) {
    BitGrid grown = known;
    forEachRow(geometry.size, rowsOfVoxels, [&](std::int64_t y, std::int64_t z) {
        const NineRows<Voxel> rows(geometry, voxels, known, y, z);
        const auto first = static_cast<std::size_t>(geometry.offset(0, y, z));
        rows.forEachBesideKnown([&](std::int64_t x) {
            const std::size_t at = first + static_cast<std::size_t>(x);
            voxels[at] = rows.meanAround(x);
            mask[at] = 1;
            grown.set(x, y, z);
        });
    });
    known = std::move(grown);
}

template <typename Voxel>
Volume filled(const Volume& volume, const VoxelArray<Voxel>& given) {
    const VolumeGeometry& geometry = volume.geometry();
    Bytes mask = dataOf(geometry, volume.scannedMask(), given);
    if (mask.empty()) return volume.withCut(nullptr);
    std::vector<Voxel> voxels = given.toVector();
    BitGrid known = bitsOf(geometry, mask);
    for (int layer = 0; layer < FilledVolume::fillReach; ++layer) growLayer(geometry, voxels, known, mask);
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
