#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "processing/tube_core/slabs/tube_slabs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/tube_core/slabs/tube_slab_sums.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#ifndef ECHOLUCENT_TUBE_SLAB_SUMS
#define ECHOLUCENT_TUBE_SLAB_SUMS
namespace echolucent::tube_slabs {

/// The volume whose voxels the tubes lie on.
template <typename Stored>
struct VoxelGrid {
    const Stored* voxels;
    const std::uint8_t* mask;  ///< null if all are data
    std::int64_t count;        ///< voxels
    Stored limit;              ///< larger ones count as this
};

/// A tube on voxels as memory holds it, without the parts outside the volume; strides in voxels. Either its columns
/// follow each other in memory (across = 1), or its slabs do (along = 1 or -1).
struct VoxelTube {
    std::int64_t first = 0;  ///< offset of the first sample of slab 0
    std::int64_t along = 0, across = 0, down = 0;
    int columns = 0, rows = 0, slabs = 0;
};

struct SumColumns {
    std::int32_t* counts;
    std::int32_t* sums;
    std::uint64_t* sumsOfSquares;
};

/// The most slabs of one call; tubes side by side take turns.
constexpr int slabsPerTurn = 16;

}  // namespace echolucent::tube_slabs
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::tube_slabs::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR
// A lane of 64 bits holds voxels of one row of one slab that follow each other, as many as fit.
using Lanes = hn::CappedTag<std::uint64_t, slabsPerTurn>;
using LaneVector = hn::Vec<Lanes>;
using Bytes = hn::Repartition<std::uint8_t, Lanes>;
using Shorts = hn::Repartition<std::uint16_t, Lanes>;
using Words = hn::Repartition<std::uint32_t, Lanes>;

template <typename Stored>
constexpr int voxelsPerLane = 8 / static_cast<int>(sizeof(Stored));

HWY_INLINE LaneVector halvesAdded(LaneVector pairs) {
    return hn::Add(hn::And(pairs, hn::Set(Lanes(), 0xFFFFFFFFu)), hn::ShiftRight<32>(pairs));
}
HWY_INLINE LaneVector shortPairsAdded(LaneVector shorts) {
    const auto words = hn::BitCast(Words(), shorts);
    return hn::BitCast(Lanes(), hn::Add(hn::And(words, hn::Set(Words(), 0xFFFFu)), hn::ShiftRight<16>(words)));
}

/// The sum of each lane's voxels.
template <typename Stored>
HWY_INLINE LaneVector sumOf(LaneVector voxels) {
    if constexpr (sizeof(Stored) == 1) return hn::SumsOf8(hn::BitCast(Bytes(), voxels));
    return halvesAdded(shortPairsAdded(voxels));
}

template <typename Stored>
HWY_INLINE LaneVector sumOfSquares(LaneVector voxels) {
    if constexpr (sizeof(Stored) == 1) {
        const auto shorts = hn::BitCast(Shorts(), voxels);
        const auto even = hn::And(shorts, hn::Set(Shorts(), 0xFF)), odd = hn::ShiftRight<8>(shorts);
        const auto evenSquares = shortPairsAdded(hn::BitCast(Lanes(), hn::Mul(even, even)));
        const auto oddSquares = shortPairsAdded(hn::BitCast(Lanes(), hn::Mul(odd, odd)));
        return halvesAdded(hn::Add(evenSquares, oddSquares));
    } else {
        const auto words = hn::BitCast(Words(), voxels);
        const auto even = hn::And(words, hn::Set(Words(), 0xFFFF)), odd = hn::ShiftRight<16>(words);
        return hn::Add(halvesAdded(hn::BitCast(Lanes(), hn::Mul(even, even))),
                       halvesAdded(hn::BitCast(Lanes(), hn::Mul(odd, odd))));
    }
}

/// The mask's bytes, one for each voxel, widened to the voxels' width: all ones if there is data.
template <typename Stored>
HWY_INLINE LaneVector dataOf(LaneVector mask) {
    const auto data = hn::VecFromMask(Bytes(), hn::Ne(hn::BitCast(Bytes(), mask), hn::Zero(Bytes())));
    if constexpr (sizeof(Stored) == 1) return hn::BitCast(Lanes(), data);
    alignas(16) static constexpr std::uint8_t twice[16] = {0, 0, 1, 1, 2, 2, 3, 3, 8, 8, 9, 9, 10, 10, 11, 11};
    return hn::BitCast(Lanes(), hn::TableLookupBytes(data, hn::LoadDup128(Bytes(), twice)));
}

template <typename Stored>
HWY_INLINE LaneVector limited(LaneVector voxels, Stored limit) {
    const hn::Repartition<Stored, Lanes> stored;
    return hn::BitCast(Lanes(), hn::Min(hn::BitCast(stored, voxels), hn::Set(stored, limit)));
}

template <typename Stored>
HWY_INLINE LaneVector gather(const Stored* first, hn::Vec<hn::RebindToSigned<Lanes>> offsets) {
    constexpr int shift = sizeof(Stored) == 1 ? 0 : 1;
    return hn::GatherOffset(Lanes(), reinterpret_cast<const std::uint64_t*>(first), hn::ShiftLeft<shift>(offsets));
}

/// Adds the slabs begin ... end - 1, at most slabsPerTurn, one to a lane. All their lanes must lie in the volume's
/// array.
template <typename Stored, bool masked>
HWY_INLINE void sumLanes(const VoxelGrid<Stored>& grid, const VoxelTube& tube, int begin, int end,
                         const SumColumns& columns) {
    const Lanes lanes;
    const hn::RebindToSigned<Lanes> offsets;
    constexpr int perLane = voxelsPerLane<Stored>;
    alignas(64) std::array<std::int64_t, slabsPerTurn> starts;
    alignas(64) std::array<std::uint64_t, slabsPerTurn> sums, squares, counts;
    for (int i = 0; i < slabsPerTurn; ++i)
        starts[static_cast<std::size_t>(i)] = std::min(i, end - begin - 1) * tube.along;
    for (int lane = 0; lane < end - begin; lane += static_cast<int>(hn::Lanes(lanes))) {
        const auto start = hn::Load(offsets, starts.data() + lane);
        auto sum = hn::Zero(lanes), square = hn::Zero(lanes), count = hn::Zero(lanes);
        for (int column = 0; column < tube.columns; column += perLane) {
            const int inside = std::min(perLane, tube.columns - column);
            const auto used =
                hn::Set(lanes, ~std::uint64_t{0} >> (8 * sizeof(Stored) * static_cast<unsigned>(perLane - inside)));
            for (int row = 0; row < tube.rows; ++row) {
                const std::int64_t at = tube.first + begin * tube.along + row * tube.down + column;
                auto voxels = hn::And(gather(grid.voxels + at, start), used);
                if (grid.limit != static_cast<Stored>(~Stored{0})) voxels = limited(voxels, grid.limit);
                if constexpr (masked) {
                    const auto data = hn::And(dataOf<Stored>(gather(grid.mask + at, start)), used);
                    voxels = hn::And(voxels, data);
                    const hn::Repartition<Stored, Lanes> stored;
                    const auto ones = hn::And(data, hn::BitCast(lanes, hn::Set(stored, 1)));
                    count = hn::Add(count, sumOf<Stored>(ones));
                }
                sum = hn::Add(sum, sumOf<Stored>(voxels));
                square = hn::Add(square, sumOfSquares<Stored>(voxels));
            }
        }
        hn::Store(sum, lanes, sums.data() + lane);
        hn::Store(square, lanes, squares.data() + lane);
        hn::Store(count, lanes, counts.data() + lane);
    }
    for (int i = 0; i < end - begin; ++i) {
        const auto k = static_cast<std::size_t>(i);
        columns.counts[begin + i] = masked ? static_cast<std::int32_t>(counts[k]) : tube.rows * tube.columns;
        columns.sums[begin + i] = static_cast<std::int32_t>(sums[k]);
        columns.sumsOfSquares[begin + i] = squares[k];
    }
}

#endif

/// Adds a line of `count` voxels, one voxel to each slab. The compiler vectorises both loops.
template <typename Stored, bool masked>
HWY_INLINE void addLine(const Stored* voxels, const std::uint8_t* mask, Stored limit, int count,
                        const SumColumns& columns) {
    for (int k = 0; k < count; ++k) {
        const std::uint32_t keep = !masked || mask[k] != 0 ? 1 : 0;
        const std::uint32_t value = keep * std::min(voxels[k], limit);
        columns.counts[k] += static_cast<std::int32_t>(keep);
        columns.sums[k] += static_cast<std::int32_t>(value);
    }
    for (int k = 0; k < count; ++k) {
        const std::uint32_t value = (!masked || mask[k] != 0 ? 1u : 0u) * std::min(voxels[k], limit);
        columns.sumsOfSquares[k] += value * value;
    }
}

/// Adds a tube whose slabs follow each other in memory.
template <typename Stored, bool masked>
HWY_INLINE void sumAlong(const VoxelGrid<Stored>& grid, const VoxelTube& tube, const SumColumns& columns) {
    const bool backwards = tube.along < 0;
    const std::int64_t first = tube.first - (backwards ? tube.slabs - 1 : 0);
    std::fill_n(columns.counts, tube.slabs, 0);
    std::fill_n(columns.sums, tube.slabs, 0);
    std::fill_n(columns.sumsOfSquares, tube.slabs, std::uint64_t{0});
    for (int row = 0; row < tube.rows; ++row)
        for (int column = 0; column < tube.columns; ++column) {
            const std::int64_t at = first + row * tube.down + column * tube.across;
            addLine<Stored, masked>(grid.voxels + at, masked ? grid.mask + at : nullptr, grid.limit, tube.slabs,
                                    columns);
        }
    if (!backwards) return;
    std::reverse(columns.counts, columns.counts + tube.slabs);
    std::reverse(columns.sums, columns.sums + tube.slabs);
    std::reverse(columns.sumsOfSquares, columns.sumsOfSquares + tube.slabs);
}

/// Adds slabs whose lanes would end behind the array, voxel by voxel.
template <typename Stored, bool masked>
HWY_INLINE void sumOneByOne(const VoxelGrid<Stored>& grid, const VoxelTube& tube, int begin, int end,
                            const SumColumns& columns) {
    for (int k = begin; k < end; ++k) {
        columns.counts[k] = columns.sums[k] = 0;
        const SumColumns slab{columns.counts + k, columns.sums + k, columns.sumsOfSquares + k};
        *slab.sumsOfSquares = 0;
        for (int row = 0; row < tube.rows; ++row)
            for (int column = 0; column < tube.columns; ++column) {
                const std::int64_t at = tube.first + k * tube.along + row * tube.down + column;
                addLine<Stored, masked>(grid.voxels + at, masked ? grid.mask + at : nullptr, grid.limit, 1, slab);
            }
    }
}

template <typename Stored, bool masked>
HWY_INLINE void sumTube(const VoxelGrid<Stored>& grid, const VoxelTube& tube, int begin, const SumColumns& columns) {
    if (tube.across != 1) {
        if (begin == 0) sumAlong<Stored, masked>(grid, tube, columns);
        return;
    }
    const int end = std::min(begin + slabsPerTurn, tube.slabs);
#if HWY_TARGET != HWY_SCALAR
    constexpr int perLane = voxelsPerLane<Stored>;
    const std::int64_t lastLane = (tube.columns - 1) / perLane * perLane + 8;
    const std::int64_t farthest = tube.first + std::max(begin * tube.along, (end - 1) * tube.along) +
                                  std::max<std::int64_t>(0, (tube.rows - 1) * tube.down) + lastLane;
    // The mask's lanes hold eight voxels each, whatever the voxels' lanes hold.
    if (farthest <= grid.count) return sumLanes<Stored, masked>(grid, tube, begin, end, columns);
#endif
    sumOneByOne<Stored, masked>(grid, tube, begin, end, columns);
}

// Highway's dispatch tables need plain functions.
void sumBytes(const VoxelGrid<std::uint8_t>& grid, const VoxelTube& tube, int begin, const SumColumns& columns) {
    grid.mask == nullptr ? sumTube<std::uint8_t, false>(grid, tube, begin, columns)
                         : sumTube<std::uint8_t, true>(grid, tube, begin, columns);
}
void sumShorts(const VoxelGrid<std::uint16_t>& grid, const VoxelTube& tube, int begin, const SumColumns& columns) {
    grid.mask == nullptr ? sumTube<std::uint16_t, false>(grid, tube, begin, columns)
                         : sumTube<std::uint16_t, true>(grid, tube, begin, columns);
}

}  // namespace echolucent::tube_slabs::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

namespace tube_slabs {

HWY_EXPORT(sumBytes);
HWY_EXPORT(sumShorts);

namespace {

/// Reverses a lateral direction that runs backwards in memory: a sum does not depend on the order.
void turnForwards(std::int64_t& stride, int count, std::int64_t& first) {
    if (stride >= 0) return;
    first += stride * (count - 1);
    stride = -stride;
}

VoxelTube voxelTube(const VolumeGeometry& geometry, const TubeSamples& tube) {
    const std::array<std::int64_t, 3> strides{1, geometry.size[0], geometry.size[0] * geometry.size[1]};
    const double half = (tube.cellSize - 1) / 2.0;
    const Vec3 corner = tube.first - tube.right * half - tube.down * half;
    VoxelTube voxels;
    std::array<std::int64_t, 3> start{};
    for (int axis = 0; axis < 3; ++axis) start[static_cast<std::size_t>(axis)] = std::llround(corner[axis]);
    const auto clip = [&](const Vec3& direction, std::int64_t& stride, int& count) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int step = static_cast<int>(direction[static_cast<int>(axis)]);
            if (step == 0) continue;
            stride = step * strides[axis];
            const std::int64_t size = geometry.size[axis], at = start[axis];
            const std::int64_t skip = std::max<std::int64_t>(0, step > 0 ? -at : at - (size - 1));
            const std::int64_t room = step > 0 ? size - at : at + 1;
            count = std::max(0, static_cast<int>(std::clamp<std::int64_t>(room, 0, tube.cellSize) -
                                                 std::min<std::int64_t>(skip, tube.cellSize)));
            start[axis] += step * skip;
        }
    };
    int unclipped = 0;
    clip(tube.right, voxels.across, voxels.columns);
    clip(tube.down, voxels.down, voxels.rows);
    clip(tube.along, voxels.along, unclipped);
    voxels.slabs = tube.slabs;
    voxels.first = start[0] * strides[0] + start[1] * strides[1] + start[2] * strides[2];
    turnForwards(voxels.across, voxels.columns, voxels.first);
    turnForwards(voxels.down, voxels.rows, voxels.first);
    if (voxels.down == 1) {
        std::swap(voxels.down, voxels.across);
        std::swap(voxels.rows, voxels.columns);
    }
    return voxels;
}

void sumTurn(const VoxelGrid<std::uint8_t>& grid, const VoxelTube& tube, int begin, const SumColumns& columns) {
    HWY_DYNAMIC_DISPATCH(sumBytes)(grid, tube, begin, columns);
}
void sumTurn(const VoxelGrid<std::uint16_t>& grid, const VoxelTube& tube, int begin, const SumColumns& columns) {
    HWY_DYNAMIC_DISPATCH(sumShorts)(grid, tube, begin, columns);
}

}  // namespace
}  // namespace tube_slabs

std::optional<std::uint32_t> exactStoredLimit(const Volume& volume) {
    if (std::holds_alternative<VoxelArray<float>>(volume.voxels())) return std::nullopt;
    const std::uint32_t largest = std::holds_alternative<VoxelArray<std::uint8_t>>(volume.voxels()) ? 0xff : 0xffff;
    if (volume.whiteLevel() >= largest) return largest;
    if (volume.whiteLevel() != std::floor(volume.whiteLevel())) return std::nullopt;
    return static_cast<std::uint32_t>(volume.whiteLevel());
}

void sumSlabs(const Volume& volume, std::uint32_t storedLimit, std::span<const TubeSamples> tubes,
              std::span<SlabSums> slabs) {
    using namespace tube_slabs;
    std::vector<VoxelTube> layout(tubes.size());
    int longest = 0;
    for (std::size_t t = 0; t < tubes.size(); ++t) {
        const auto count = static_cast<std::size_t>(tubes[t].slabs);
        slabs[t].counts.assign(count, 0);
        slabs[t].sums.assign(count, 0);
        slabs[t].sumsOfSquares.assign(count, 0);
        if (count > 0) layout[t] = voxelTube(volume.geometry(), tubes[t]);
        longest = std::max(longest, tubes[t].slabs);
    }
    const auto sum = [&]<typename Stored>(const VoxelArray<Stored>& voxels) {
        const VoxelGrid<Stored> grid{voxels.data(), volume.dataMaskOrNull(), volume.geometry().voxelCount(),
                                     static_cast<Stored>(storedLimit)};
        // Takes one depth of all tubes before the next depth: neighbours in the grid share cache lines.
        for (int begin = 0; begin < longest; begin += slabsPerTurn)
            for (std::size_t t = 0; t < tubes.size(); ++t) {
                if (begin >= tubes[t].slabs || layout[t].columns == 0 || layout[t].rows == 0) continue;
                sumTurn(grid, layout[t], begin,
                        {slabs[t].counts.data(), slabs[t].sums.data(), slabs[t].sumsOfSquares.data()});
            }
    };
    if (const auto* bytes = std::get_if<VoxelArray<std::uint8_t>>(&volume.voxels()))
        sum(*bytes);
    else
        sum(std::get<VoxelArray<std::uint16_t>>(volume.voxels()));
}

}  // namespace echolucent
#endif
