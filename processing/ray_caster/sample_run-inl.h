// Trilinear and nearest samples as Highway vectors; compiled once for each instruction set.
#include <limits>
#include <type_traits>

#include "processing/ray_caster/sample_run.h"

#include <hwy/highway.h>

#if defined(ECHOLUCENT_SAMPLE_RUN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_SAMPLE_RUN_INL
#undef ECHOLUCENT_SAMPLE_RUN_INL
#else
#define ECHOLUCENT_SAMPLE_RUN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Eight lanes at most: runs are short, and wider ones would mostly idle. No fused multiply-add: the same bits anywhere.
using Floats = hn::CappedTag<float, 8>;
using Ints = hn::RebindToSigned<Floats>;
using FloatVector = hn::Vec<Floats>;
using IntVector = hn::Vec<Ints>;

HWY_INLINE FloatVector between(FloatVector left, FloatVector right, FloatVector share) {
    return hn::Add(left, hn::Mul(share, hn::Sub(right, left)));
}

/// Two voxels that follow each other along x.
struct Pair {
    FloatVector left, right;
};

/// The voxels at each byte offset and the next along x.
template <typename Voxel>
HWY_INLINE Pair pairAt(const Voxel* first, IntVector offset) {
    const Floats floats;
    if constexpr (std::is_same_v<Voxel, float>) {
        return {hn::GatherOffset(floats, first, offset), hn::GatherOffset(floats, first + 1, offset)};
    } else {
        constexpr int bits = 8 * sizeof(Voxel);
        const Ints ints;
        const auto mask = hn::Set(ints, sizeof(Voxel) == 1 ? 0xFF : 0xFFFF);
        const auto word = hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(first), offset);
        return {hn::ConvertTo(floats, hn::And(word, mask)),
                hn::ConvertTo(floats, hn::And(hn::ShiftRight<bits>(word), mask))};
    }
}

template <typename Voxel>
HWY_INLINE FloatVector meanOfPair(const Voxel* first, IntVector offset, FloatVector share) {
    const Pair pair = pairAt(first, offset);
    return between(pair.left, pair.right, share);
}

/// A sum of values by their weights, and of the weights.
struct Weighted {
    FloatVector sum, weight;
};

HWY_INLINE Weighted between(const Weighted& left, const Weighted& right, FloatVector share) {
    return {between(left.sum, right.sum, share), between(left.weight, right.weight, share)};
}

/// Like meanOfPair, of the voxels with data alone.
template <typename Voxel>
HWY_INLINE Weighted dataOfPair(const Voxel* first, const std::uint8_t* mask, IntVector byteOffset, IntVector offset,
                               FloatVector share) {
    const Floats floats;
    const Pair values = pairAt(first, byteOffset), data = pairAt(mask, offset);
    const auto hasLeft = hn::Gt(data.left, hn::Zero(floats)), hasRight = hn::Gt(data.right, hn::Zero(floats));
    const auto leftShare = hn::Sub(hn::Set(floats, 1.0f), share);
    return {hn::Add(hn::IfThenElseZero(hasLeft, hn::Mul(values.left, leftShare)),
                    hn::IfThenElseZero(hasRight, hn::Mul(values.right, share))),
            hn::Add(hn::IfThenElseZero(hasLeft, leftShare), hn::IfThenElseZero(hasRight, share))};
}

/// Voxel offset of the cell at each position, and the shares of its far corners.
struct Cells {
    IntVector offset;
    FloatVector shareX, shareY, shareZ;
};

template <typename Voxel>
HWY_INLINE IntVector offsetOf(const VoxelBlock<Voxel>& block, IntVector x, IntVector y, IntVector z) {
    const Ints ints;
    return hn::Add(x,
                   hn::Add(hn::Mul(y, hn::Set(ints, block.rowStride)), hn::Mul(z, hn::Set(ints, block.sliceStride))));
}

template <typename Voxel>
HWY_INLINE IntVector bytes(IntVector offset) {
    if constexpr (sizeof(Voxel) == 1)
        return offset;
    else
        return hn::ShiftLeft < sizeof(Voxel) == 2 ? 1 : 2 > (offset);
}

template <typename Voxel>
HWY_INLINE Cells cellsAt(const VoxelBlock<Voxel>& block, FloatVector x, FloatVector y, FloatVector z) {
    const Floats floats;
    const Ints ints;
    const auto cellX = hn::ConvertTo(ints, x), cellY = hn::ConvertTo(ints, y), cellZ = hn::ConvertTo(ints, z);
    return {offsetOf(block, cellX, cellY, cellZ), hn::Sub(x, hn::ConvertTo(floats, cellX)),
            hn::Sub(y, hn::ConvertTo(floats, cellY)), hn::Sub(z, hn::ConvertTo(floats, cellZ))};
}

template <typename Voxel>
HWY_INLINE FloatVector trilinear(const VoxelBlock<Voxel>& block, FloatVector x, FloatVector y, FloatVector z) {
    const Cells cells = cellsAt(block, x, y, z);
    const auto offset = bytes<Voxel>(cells.offset);
    const auto slice = [&](const Voxel* first) {
        return between(meanOfPair(first, offset, cells.shareX),
                       meanOfPair(first + block.rowStride, offset, cells.shareX), cells.shareY);
    };
    return between(slice(block.first), slice(block.first + block.sliceStride), cells.shareZ);
}

/// Sum over the voxels with data around each position, by their trilinear weights.
template <typename Voxel>
HWY_INLINE Weighted trilinearData(const VoxelBlock<Voxel>& block, FloatVector x, FloatVector y, FloatVector z) {
    const Cells cells = cellsAt(block, x, y, z);
    const auto offset = bytes<Voxel>(cells.offset);
    const auto row = [&](std::ptrdiff_t shift) {
        return dataOfPair(block.first + shift, block.mask + shift, offset, cells.offset, cells.shareX);
    };
    const auto slice = [&](std::ptrdiff_t shift) {
        return between(row(shift), row(shift + block.rowStride), cells.shareY);
    };
    return between(slice(0), slice(block.sliceStride), cells.shareZ);
}

template <typename Voxel>
HWY_INLINE IntVector nearestOffset(const VoxelBlock<Voxel>& block, FloatVector x, FloatVector y, FloatVector z) {
    const Ints ints;
    const auto half = hn::Set(Floats(), 0.5f);
    return offsetOf(block, hn::ConvertTo(ints, hn::Add(x, half)), hn::ConvertTo(ints, hn::Add(y, half)),
                    hn::ConvertTo(ints, hn::Add(z, half)));
}

/// One coordinate of the samples at start + index * step.
HWY_INLINE FloatVector coordinate(float start, float step, FloatVector index) {
    return hn::Add(hn::Set(Floats(), start), hn::Mul(index, hn::Set(Floats(), step)));
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
