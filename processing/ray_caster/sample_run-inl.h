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

/// The voxel at each byte offset.
template <typename Voxel>
HWY_INLINE FloatVector voxelAt(const Voxel* first, IntVector offset) {
    if constexpr (std::is_same_v<Voxel, float>) {
        return hn::GatherOffset(Floats(), first, offset);
    } else {
        const Ints ints;
        const auto word = hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(first), offset);
        return hn::ConvertTo(Floats(), hn::And(word, hn::Set(ints, sizeof(Voxel) == 1 ? 0xFF : 0xFFFF)));
    }
}

/// Between the voxel at each byte offset and the next along x.
template <typename Voxel>
HWY_INLINE FloatVector pairAt(const Voxel* first, IntVector offset, FloatVector share) {
    const Floats floats;
    if constexpr (std::is_same_v<Voxel, float>) {
        return between(hn::GatherOffset(floats, first, offset), hn::GatherOffset(floats, first + 1, offset), share);
    } else {
        constexpr int bits = 8 * sizeof(Voxel);
        const Ints ints;
        const auto mask = hn::Set(ints, sizeof(Voxel) == 1 ? 0xFF : 0xFFFF);
        const auto word = hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(first), offset);
        return between(hn::ConvertTo(floats, hn::And(word, mask)),
                       hn::ConvertTo(floats, hn::And(hn::ShiftRight<bits>(word), mask)), share);
    }
}

template <typename Voxel>
HWY_INLINE IntVector byteOffset(const VoxelBlock<Voxel>& block, IntVector x, IntVector y, IntVector z) {
    const Ints ints;
    const auto rows = hn::Add(hn::Mul(y, hn::Set(ints, block.rowStride)), hn::Mul(z, hn::Set(ints, block.sliceStride)));
    return hn::Mul(hn::Add(x, rows), hn::Set(ints, static_cast<std::int32_t>(sizeof(Voxel))));
}

template <typename Voxel>
HWY_INLINE FloatVector trilinear(const VoxelBlock<Voxel>& block, FloatVector x, FloatVector y, FloatVector z) {
    const Floats floats;
    const Ints ints;
    const auto cellX = hn::ConvertTo(ints, x), cellY = hn::ConvertTo(ints, y), cellZ = hn::ConvertTo(ints, z);
    const auto shareX = hn::Sub(x, hn::ConvertTo(floats, cellX)), shareY = hn::Sub(y, hn::ConvertTo(floats, cellY));
    const auto shareZ = hn::Sub(z, hn::ConvertTo(floats, cellZ));
    const auto offset = byteOffset(block, cellX, cellY, cellZ);
    const Voxel* near = block.first;
    const Voxel* far = near + block.sliceStride;
    const auto nearValue = between(pairAt(near, offset, shareX), pairAt(near + block.rowStride, offset, shareX), shareY);
    const auto farValue = between(pairAt(far, offset, shareX), pairAt(far + block.rowStride, offset, shareX), shareY);
    return between(nearValue, farValue, shareZ);
}

template <typename Voxel>
HWY_INLINE FloatVector nearest(const VoxelBlock<Voxel>& block, FloatVector x, FloatVector y, FloatVector z) {
    const Ints ints;
    const auto half = hn::Set(Floats(), 0.5f);
    return voxelAt(block.first, byteOffset(block, hn::ConvertTo(ints, hn::Add(x, half)),
                                           hn::ConvertTo(ints, hn::Add(y, half)), hn::ConvertTo(ints, hn::Add(z, half))));
}

/// One coordinate of the samples at start + index * step.
HWY_INLINE FloatVector coordinate(float start, float step, FloatVector index) {
    return hn::Add(hn::Set(Floats(), start), hn::Mul(index, hn::Set(Floats(), step)));
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
