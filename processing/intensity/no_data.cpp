#include "processing/intensity/no_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <memory_resource>
#include <optional>
#include <vector>

#include "processing/parallel.h"
#include "processing/volume/bit_grid.h"

namespace echolucent {

namespace {

/// A smaller share of the volume is not worth the risk of taking fluid for no data.
constexpr double smallestShare = 0.02;
/// The outside of a sector is solid. At least this share of the zeros that reach the border survives thinning by
/// `thinnest` voxels and growing back. Fluid partly clipped to zero is riddled with echoes and does not survive.
constexpr double solidShare = 0.7;
constexpr int thinnest = 2;

/// What an empty voxel holds.
struct Blank {
    double stored = 0.0;
    bool orLess = false;  ///< whether what lies below is empty too
};

template <typename Voxel>
bool isBlank(Voxel value, const Blank& blank) {
    if constexpr (std::is_floating_point_v<Voxel>)
        return value == static_cast<Voxel>(blank.stored) ||
               (blank.orLess && value < static_cast<Voxel>(blank.stored)) || !std::isfinite(value);
    else
        return static_cast<double>(value) == blank.stored;
}

/// What the outside of a sector may hold, the likelier first: black, and the file's 0 if that is not black.
std::vector<Blank> blanksOf(const ValueScale& scale) {
    if (scale.black == 0.0) return {Blank{}};
    return {Blank{0.0, true}, Blank{scale.storedValue(0.0), false}};
}

template <typename Voxel>
std::uint64_t blankBits(const Voxel* voxels, const std::uint8_t* mask, std::int64_t count, const Blank& blank) {
    std::uint64_t bits = 0;
    for (std::int64_t x = 0; x < count; ++x)
        if (isBlank(voxels[x], blank) || (mask != nullptr && mask[x] == 0)) bits |= std::uint64_t{1} << x;
    return bits;
}

/// Which of 64 bytes are zero, as one bit each.
std::uint64_t zeroBytes(const std::uint8_t* voxels) {
    constexpr std::uint64_t low7 = 0x7F7F7F7F7F7F7F7FULL;
    std::uint64_t bits = 0;
    for (int group = 0; group < 8; ++group) {
        std::uint64_t bytes;
        std::memcpy(&bytes, voxels + 8 * group, 8);
        const std::uint64_t zero = ~(((bytes & low7) + low7) | bytes | low7);  // the top bit of each zero byte
        bits |= ((zero >> 7) * 0x0102040810204080ULL >> 56) << (8 * group);
    }
    return bits;
}

/// Voxels that are empty, not finite, or no data already.
BitGrid blankVoxels(const Volume& volume, const Blank& of) {
    const VolumeGeometry& geometry = volume.geometry();
    BitGrid blank(geometry.size);
    const std::uint8_t* mask = volume.dataMaskOrNull();
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            parallelFor(LoopRange<std::int64_t>(0, geometry.size[1] * geometry.size[2], 64), [&](const auto& rows) {
                for (std::int64_t row = rows.begin(); row < rows.end(); ++row)
                    for (std::int64_t x = 0; x < geometry.size[0]; x += 64) {
                        const std::int64_t offset = row * geometry.size[0] + x;
                        const std::int64_t count = std::min<std::int64_t>(64, geometry.size[0] - x);
                        std::uint64_t& word = blank.row(row % geometry.size[1], row / geometry.size[1])[x / 64];
                        if (std::is_same_v<Voxel, std::uint8_t> && mask == nullptr && count == 64 && of.stored == 0.0)
                            word = zeroBytes(reinterpret_cast<const std::uint8_t*>(voxels.data() + offset));
                        else
                            word = blankBits(voxels.data() + offset, mask ? mask + offset : nullptr, count, of);
                    }
            });
        },
        volume.voxels());
    return blank;
}

/// Whether a region holds a corner of the grid. A sector does not reach all corners.
bool holdsCorner(const BitGrid& region) {
    const auto& size = region.size();
    for (int corner = 0; corner < 8; ++corner)
        if (region.at(corner & 1 ? size[0] - 1 : 0, corner & 2 ? size[1] - 1 : 0, corner & 4 ? size[2] - 1 : 0))
            return true;
    return false;
}

/// The parts of the blank region that survive thinning and growing back. Tongues into dark fluid fall off.
BitGrid solidPart(const BitGrid& outside) {
    BitGrid core = outside;
    for (int i = 0; i < thinnest; ++i) core = core.eroded();
    core = core.connectedToBorder();
    for (int i = 0; i < thinnest; ++i) core = core.dilated() & outside;
    return core;
}

DataMask maskWithout(const BitGrid& region, const Volume& volume, std::pmr::memory_resource& memory) {
    const VolumeGeometry& geometry = volume.geometry();
    const DataMask& own = volume.dataMask();
    const auto owner = std::make_shared<std::pmr::vector<std::uint8_t>>(own.begin(), own.end(), &memory);
    std::pmr::vector<std::uint8_t>& mask = *owner;
    if (mask.empty()) mask.resize(static_cast<std::size_t>(geometry.voxelCount()), 1);
    parallelFor(LoopRange<std::int64_t>(0, geometry.size[1] * geometry.size[2], 64), [&](const auto& rows) {
        for (std::int64_t row = rows.begin(); row < rows.end(); ++row) {
            const std::uint64_t* words = region.row(row % geometry.size[1], row / geometry.size[1]);
            std::uint8_t* target = mask.data() + row * geometry.size[0];
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                if (x % 64 == 0 && words[x / 64] == 0) {
                    x += 63;
                    continue;
                }
                if (words[x / 64] >> (x % 64) & 1) target[x] = 0;
            }
        }
    });
    return {owner, mask};
}

/// The outside of a sector among empty voxels; no value if they are none.
std::optional<BitGrid> outsideAmong(const BitGrid& blank, double voxels) {
    BitGrid outside = blank.connectedToBorder();
    const auto outsideCount = static_cast<double>(outside.count());
    if (outsideCount < smallestShare * voxels || outsideCount == voxels || !holdsCorner(outside)) return std::nullopt;
    const BitGrid solid = solidPart(outside);
    const auto solidCount = static_cast<double>(solid.count());
    if (solidCount < smallestShare * voxels || solidCount < solidShare * outsideCount || !holdsCorner(solid))
        return std::nullopt;
    // If echoes are thinner than the outside between them, they are wires in water and no sector.
    const BitGrid closed = solid.dilated().eroded();
    if (static_cast<double>(closed.count()) == voxels) return std::nullopt;
    // Frayed edges belong to the outside; echoes never do.
    return closed & outside;
}

}  // namespace

DataMask guessDataMask(const Volume& volume, std::pmr::memory_resource& memory) {
    const auto voxels = static_cast<double>(volume.geometry().voxelCount());
    for (const Blank& blank : blanksOf(volume.valueScale()))
        if (const auto outside = outsideAmong(blankVoxels(volume, blank), voxels))
            return maskWithout(*outside, volume, memory);
    return volume.dataMask();
}

DataMask dataMaskWithoutGuess(const Volume& volume) {
    std::vector<std::uint8_t> mask = volume.dataMask().toVector();
    const DataMask& scanned = volume.scannedMask();
    const std::vector<Blank> blanks = blanksOf(volume.valueScale());
    std::visit(
        [&](const auto& voxels) {
            const auto wasGuessed = [&](std::size_t i) {
                return std::isfinite(static_cast<double>(voxels[i])) &&
                       std::ranges::any_of(blanks, [&](const Blank& blank) { return isBlank(voxels[i], blank); });
            };
            // What a scalpel cut was no guess.
            for (std::size_t i = 0; i < scanned.size(); ++i)
                if (scanned[i] == 0 && wasGuessed(i)) mask[i] = 1;
        },
        volume.voxels());
    if (std::find(mask.begin(), mask.end(), 0) == mask.end()) mask.clear();
    return mask;
}

}  // namespace echolucent
