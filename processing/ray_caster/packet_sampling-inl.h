// Samples of the volume for a packet of rays, one lane a ray; compiled once for each instruction set.
#include <algorithm>
#include <cstring>
#include <type_traits>

#include "processing/ray_caster/kernel_job.h"

#include <hwy/highway.h>

#if defined(ECHOLUCENT_PACKET_SAMPLING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_SAMPLING_INL
#undef ECHOLUCENT_PACKET_SAMPLING_INL
#else
#define ECHOLUCENT_PACKET_SAMPLING_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using FloatVector = hn::Vec<Floats>;
using IntVector = hn::Vec<Ints>;
using LaneMask = hn::Mask<Floats>;

constexpr int lanes = static_cast<int>(hn::MaxLanes(Floats()));
constexpr int packetColumns = lanes >= 8 ? 4 : lanes >= 4 ? 2 : 1;
constexpr int packetRows = lanes / packetColumns;

HWY_INLINE FloatVector set(float value) { return hn::Set(Floats(), value); }
HWY_INLINE IntVector set(std::int32_t value) { return hn::Set(Ints(), value); }

/// Towards zero, of numbers that fit 32 bits: Highway's ConvertTo spends four instructions more on those that do not.
HWY_INLINE IntVector truncated(FloatVector value) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    return IntVector{_mm512_cvttps_epi32(value.raw)};
#elif HWY_TARGET == HWY_AVX2
    return IntVector{_mm256_cvttps_epi32(value.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    return IntVector{_mm_cvttps_epi32(value.raw)};
#else
    return hn::ConvertTo(Ints(), value);
#endif
}

/// Positions in 1/65536 of a cell from a corner, at or after it.
struct Position {
    IntVector x, y, z;
};
constexpr std::int32_t oneCell = 1 << 16;

/// Two dwords for each lane, which stand beside each other in memory, `offset` times 2^shift bytes after `base`.
struct DwordPair {
    IntVector low, high;
};
HWY_INLINE FloatVector between(FloatVector left, FloatVector right, FloatVector share) {
    return hn::MulAdd(share, hn::Sub(right, left), left);
}

/// Trilinear mean of bytes, in fixed point: values times 128, shares of 15 bits. Off by at most 1/50 of a byte's step; exact
/// where all eight are equal.
constexpr float byteScale = 128.0f * 32767.0f;

#if HWY_TARGET == HWY_SCALAR

/// One ray at a time, without vectors: what all others are compared to.
template <int shift>
HWY_INLINE DwordPair loadPairs(const void* base, IntVector offset) {
    std::int32_t pair[2];
    std::memcpy(pair, static_cast<const char*>(base) + (static_cast<std::ptrdiff_t>(offset.raw) << shift), sizeof(pair));
    return {set(pair[0]), set(pair[1])};
}

HWY_INLINE FloatVector meanOfBytes(const std::uint8_t* cells, std::int64_t sliceStride, IntVector offset,
                                   const Position& at) {
    const std::uint8_t* const first = cells + static_cast<std::ptrdiff_t>(offset.raw) * voxelsPerCell;
    const std::uint8_t* const second = first + sliceStride * voxelsPerCell;
    const auto share = [](IntVector position) { return (position.raw & 0xFFFF) >> 1; };
    const auto mean = [](int left, int right, int part) { return left + (((right - left) * part + (1 << 14)) >> 15); };
    const int x = share(at.x), y = share(at.y), z = share(at.z);
    const auto alongZ = [&](int voxel) { return mean(first[voxel] << 7, second[voxel] << 7, z); };
    const int left = mean(alongZ(0), alongZ(1), y), right = mean(alongZ(2), alongZ(3), y);
    return set(static_cast<float>(left * (32767 - x) + right * x));
}

#else

using Words = hn::Repartition<std::int16_t, Floats>;
using Bytes = hn::Repartition<std::uint8_t, Floats>;
using Pairs = hn::Repartition<std::int64_t, Floats>;
using HalfInts = hn::Half<Ints>;

template <int shift>
HWY_INLINE DwordPair loadPairs(const void* base, IntVector offset) {
    const Pairs pairs;
    const Ints ints;
    const auto* from = static_cast<const std::int64_t*>(base);
    const auto first = hn::ShiftLeft<shift>(hn::PromoteTo(pairs, hn::LowerHalf(HalfInts(), offset)));
    const auto second = hn::ShiftLeft<shift>(hn::PromoteTo(pairs, hn::UpperHalf(HalfInts(), offset)));
    const auto lower = hn::BitCast(ints, hn::GatherOffset(pairs, from, first));
    const auto upper = hn::BitCast(ints, hn::GatherOffset(pairs, from, second));
    return {hn::ConcatEven(ints, upper, lower), hn::ConcatOdd(ints, upper, lower)};
}

/// The upper 15 bits below the point, in both halves of each dword.
HWY_INLINE hn::Vec<Words> wordShares(IntVector position) {
    alignas(16) static constexpr std::uint8_t pattern[16] = {0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13};
    const Bytes bytes;
    const hn::RebindToUnsigned<Words> bits;
    const auto share = hn::TableLookupBytes(hn::BitCast(bytes, position), hn::LoadDup128(bytes, pattern));
    return hn::BitCast(Words(), hn::ShiftRight<1>(hn::BitCast(bits, share)));
}
HWY_INLINE hn::Vec<Words> between(hn::Vec<Words> left, hn::Vec<Words> right, hn::Vec<Words> share) {
    return hn::Add(left, hn::MulFixedPoint15(hn::Sub(right, left), share));
}
HWY_INLINE FloatVector meanOfBytes(const std::uint8_t* cells, std::int64_t sliceStride, IntVector offset,
                                   const Position& at) {
    const Ints ints;
    const Words words;
    const auto bytes = hn::ShiftLeft<1>(offset);
    const auto load = [&](const std::uint8_t* base) {
        return hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(base), bytes);
    };
    const auto first = load(cells), second = load(cells + sliceStride * voxelsPerCell);
    const auto every = hn::Set(ints, 0x7F807F80);
    const auto even = [&](IntVector four) { return hn::BitCast(words, hn::And(hn::ShiftLeft<7>(four), every)); };
    const auto odd = [&](IntVector four) { return hn::BitCast(words, hn::And(hn::ShiftRight<1>(four), every)); };
    const auto shareZ = wordShares(at.z);
    const auto above = between(even(first), even(second), shareZ), below = between(odd(first), odd(second), shareZ);
    // The low half of each dword is of x, the high one of x + 1.
    const auto slices = between(above, below, wordShares(at.y));
    const auto weights = hn::Xor(wordShares(at.x), hn::BitCast(words, hn::Set(ints, 0x00007FFF)));
    auto rest = hn::Zero(ints);
    const auto sum = hn::ReorderWidenMulAccumulate(ints, slices, weights, hn::Zero(ints), rest);
    return hn::ConvertTo(Floats(), hn::RearrangeToOddPlusEven(sum, rest));
}

#endif

HWY_INLINE FloatVector shareOf(IntVector position) {
    return hn::Mul(hn::ConvertTo(Floats(), hn::And(position, set(oneCell - 1))), set(1.0f / oneCell));
}

/// A volume's cells counted from a corner.
template <typename Voxel>
struct Cells {
    const Voxel* cells;
    const std::uint8_t* mask;  ///< null: all voxels around carry data
    std::int64_t rowStride, sliceStride;

    HWY_INLINE IntVector offsetOf(const Position& at) const {
        const auto row = hn::Mul(hn::ShiftRight<16>(at.y), set(static_cast<std::int32_t>(rowStride)));
        const auto slice = hn::Mul(hn::ShiftRight<16>(at.z), set(static_cast<std::int32_t>(sliceStride)));
        return hn::Add(hn::Add(row, slice), hn::ShiftRight<16>(at.x));
    }
};

HWY_INLINE FloatVector meanOf(const Cells<std::uint8_t>& volume, IntVector offset, const Position& at) {
    return hn::Mul(meanOfBytes(volume.cells, volume.sliceStride, offset, at), set(1.0f / byteScale));
}
HWY_INLINE FloatVector meanOf(const Cells<std::uint16_t>& volume, IntVector offset, const Position& at) {
    const auto shareX = shareOf(at.x), shareY = shareOf(at.y);
    const auto slice = [&](std::int64_t first) {
        const DwordPair cell = loadPairs<2>(volume.cells + first * voxelsPerCell, offset);
        const auto above = [](IntVector two) { return hn::ConvertTo(Floats(), hn::And(two, set(0xFFFF))); };
        const auto below = [](IntVector two) {
            const hn::RebindToUnsigned<Ints> bits;
            return hn::ConvertTo(Floats(), hn::BitCast(Ints(), hn::ShiftRight<16>(hn::BitCast(bits, two))));
        };
        return between(between(above(cell.low), above(cell.high), shareX),
                       between(below(cell.low), below(cell.high), shareX), shareY);
    };
    return between(slice(0), slice(volume.sliceStride), shareOf(at.z));
}
HWY_INLINE FloatVector meanOf(const Cells<float>& volume, IntVector offset, const Position& at) {
    const auto shareX = shareOf(at.x), shareY = shareOf(at.y);
    const auto column = [&](std::int64_t first) {
        const DwordPair cell = loadPairs<3>(volume.cells + first * voxelsPerCell, offset);
        return between(hn::BitCast(Floats(), cell.low), hn::BitCast(Floats(), cell.high), shareY);
    };
    const auto slice = [&](std::int64_t first) { return between(column(first), column(first + 1), shareX); };
    return between(slice(0), slice(volume.sliceStride), shareOf(at.z));
}

/// Stored values there, 0 for what carries no data, and the share of the weight that does.
struct Sample {
    FloatVector value, weight;
};
template <typename Voxel>
HWY_INLINE Sample sampleAt(const Cells<Voxel>& volume, const Position& at, LaneMask active) {
    // Lanes without a sample here read the corner itself.
    const auto offset = hn::IfThenElseZero(hn::RebindMask(Ints(), active), volume.offsetOf(at));
    Sample sample{meanOf(volume, offset, at), set(1.0f)};
    if (volume.mask != nullptr)
        sample.weight = hn::Mul(meanOfBytes(volume.mask, volume.sliceStride, offset, at), set(1.0f / (byteScale * 255.0f)));
    return sample;
}

/// Each component on the nearest voxel: in the cell of that number it is the lower one.
HWY_INLINE Position nearestVoxel(const Position& at) {
    const auto round = [](IntVector value) {
        return hn::And(hn::Add(value, set(oneCell / 2)), set(~(oneCell - 1)));
    };
    return {round(at.x), round(at.y), round(at.z)};
}

/// Table positions; -1 where less than half the weight is on voxels with data.
template <typename Voxel>
HWY_INLINE FloatVector tablePositionAt(const Cells<Voxel>& volume, const Position& at, float toTable, LaneMask active) {
    Sample sample = sampleAt(volume, at, active);
    const auto highest = set(static_cast<float>(TransferTable::intervals));
    if (volume.mask == nullptr) {
        auto position = hn::Min(hn::Mul(sample.value, set(toTable)), highest);
        if constexpr (std::is_same_v<Voxel, float>) position = hn::Max(position, set(0.0f));
        return position;
    }
    const auto enough = hn::Ge(sample.weight, set(0.5f));
    const auto mean = hn::Div(sample.value, hn::IfThenElse(enough, sample.weight, set(1.0f)));
    const auto position = hn::Max(hn::Min(hn::Mul(mean, set(toTable)), highest), set(0.0f));
    return hn::IfThenElse(enough, position, set(-1.0f));
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
