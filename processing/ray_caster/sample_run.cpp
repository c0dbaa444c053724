#include "processing/ray_caster/sample_run.h"

#include <limits>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/ray_caster/sample_run.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

/// The mean of the voxel at each byte offset and the next along x.
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

template <typename Voxel>
HWY_INLINE FloatVector tablePosition(FloatVector value, float toTable) {
    const Floats floats;
    const auto scaled = hn::Mul(value, hn::Set(floats, toTable));
    const auto position = hn::Min(hn::Max(scaled, hn::Zero(floats)),
                                  hn::Set(floats, static_cast<float>(TransferTable::intervals)));
    if constexpr (std::is_same_v<Voxel, float>) {
        const auto finite = hn::Le(hn::Abs(value), hn::Set(floats, std::numeric_limits<float>::max()));
        return hn::IfThenElse(finite, position, hn::Set(floats, -1.0f));
    } else {
        return position;
    }
}

template <typename Voxel, bool isNearest>
HWY_INLINE void along(const VoxelBlock<Voxel>& block, const float* start, const float* step, int count, float toTable,
                      float* positions) {
    const Floats floats;
    const auto last = hn::Set(floats, static_cast<float>(count - 1));
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(floats))) {
        // Lanes beyond the last sample repeat it: they must read nothing else.
        const auto index = hn::Min(hn::Iota(floats, static_cast<float>(i)), last);
        const auto x = hn::Add(hn::Set(floats, start[0]), hn::Mul(index, hn::Set(floats, step[0])));
        const auto y = hn::Add(hn::Set(floats, start[1]), hn::Mul(index, hn::Set(floats, step[1])));
        const auto z = hn::Add(hn::Set(floats, start[2]), hn::Mul(index, hn::Set(floats, step[2])));
        const auto value = isNearest ? nearest(block, x, y, z) : trilinear(block, x, y, z);
        hn::StoreU(tablePosition<Voxel>(value, toTable), floats, positions + i);
    }
}

template <typename Voxel>
HWY_INLINE void eight(const VoxelBlock<Voxel>& block, const float* x, const float* y, const float* z, float* values) {
    const Floats floats;
    for (std::size_t i = 0; i < 8; i += hn::Lanes(floats))
        hn::StoreU(trilinear(block, hn::LoadU(floats, x + i), hn::LoadU(floats, y + i), hn::LoadU(floats, z + i)),
                   floats, values + i);
}

// Highway's dispatch tables need plain functions.
#define ECHOLUCENT_SAMPLERS(Voxel, Name)                                                                             \
    void trilinear##Name(const VoxelBlock<Voxel>& block, const float* start, const float* step, int count,           \
                         float toTable, float* positions) {                                                          \
        along<Voxel, false>(block, start, step, count, toTable, positions);                                          \
    }                                                                                                                \
    void nearest##Name(const VoxelBlock<Voxel>& block, const float* start, const float* step, int count,             \
                       float toTable, float* positions) {                                                            \
        along<Voxel, true>(block, start, step, count, toTable, positions);                                           \
    }                                                                                                                \
    void eight##Name(const VoxelBlock<Voxel>& block, const float* x, const float* y, const float* z,                 \
                     float* values) {                                                                                \
        eight<Voxel>(block, x, y, z, values);                                                                        \
    }
ECHOLUCENT_SAMPLERS(std::uint8_t, Bytes)
ECHOLUCENT_SAMPLERS(std::uint16_t, Words)
ECHOLUCENT_SAMPLERS(float, Floating)
#undef ECHOLUCENT_SAMPLERS

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::ray_casting {

#define ECHOLUCENT_SAMPLERS(Voxel, Name)                                                                             \
    HWY_EXPORT(trilinear##Name);                                                                                     \
    HWY_EXPORT(nearest##Name);                                                                                       \
    HWY_EXPORT(eight##Name);                                                                                         \
    template <>                                                                                                      \
    void tablePositionsAlong(const VoxelBlock<Voxel>& block, Interpolation interpolation, Float4 start, Float4 step, \
                             int count, float toTable, float* positions) {                                           \
        const float starts[3] = {start[0], start[1], start[2]}, steps[3] = {step[0], step[1], step[2]};              \
        if (interpolation == Interpolation::nearest)                                                                 \
            HWY_DYNAMIC_DISPATCH(nearest##Name)(block, starts, steps, count, toTable, positions);                    \
        else                                                                                                         \
            HWY_DYNAMIC_DISPATCH(trilinear##Name)(block, starts, steps, count, toTable, positions);                  \
    }                                                                                                                \
    template <>                                                                                                      \
    void trilinearAtEight(const VoxelBlock<Voxel>& block, const float* x, const float* y, const float* z,            \
                          float* values) {                                                                           \
        HWY_DYNAMIC_DISPATCH(eight##Name)(block, x, y, z, values);                                                   \
    }
ECHOLUCENT_SAMPLERS(std::uint8_t, Bytes)
ECHOLUCENT_SAMPLERS(std::uint16_t, Words)
ECHOLUCENT_SAMPLERS(float, Floating)
#undef ECHOLUCENT_SAMPLERS

}  // namespace echolucent::ray_casting
#endif
