// Samples of the volume for a packet of rays, one lane a ray. Compiled once for each instruction set.
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

/// Rounds numbers that fit into 32 bits towards zero. Highway's ConvertTo also handles others, with four instructions
/// more.
HWY_INLINE IntVector truncated(FloatVector value) {
#if HWY_TARGET == HWY_AVX3
    return IntVector{_mm512_cvttps_epi32(value.raw)};
#elif HWY_TARGET == HWY_AVX2
    return IntVector{_mm256_cvttps_epi32(value.raw)};
#elif HWY_TARGET == HWY_SSE4
    return IntVector{_mm_cvttps_epi32(value.raw)};
#else
    return hn::ConvertTo(Ints(), value);
#endif
}

/// Rounds numbers that fit into 32 bits to the nearest.
HWY_INLINE IntVector rounded(FloatVector value) {
#if HWY_TARGET == HWY_AVX3
    return IntVector{_mm512_cvtps_epi32(value.raw)};
#elif HWY_TARGET == HWY_AVX2
    return IntVector{_mm256_cvtps_epi32(value.raw)};
#elif HWY_TARGET == HWY_SSE4
    return IntVector{_mm_cvtps_epi32(value.raw)};
#else
    return hn::NearestInt(value);
#endif
}

/// Positions in 1/65536 of a cube from a corner. Those of samples are not negative; a gradient's places may be.
struct Position {
    IntVector x, y, z;

    HWY_INLINE Position operator+(const Position& way) const {
        return {hn::Add(x, way.x), hn::Add(y, way.y), hn::Add(z, way.z)};
    }
};
constexpr std::int32_t oneCube = 1 << 16;

/// A vector of numbers that lie apart in memory, `offset` times 2^shift bytes after `base` for each lane: one load
/// after the other. Gathers are at most as quick, and some processors' microcode makes them several times as slow
/// (docs/experiments.md).
template <typename Number, int count, int shift>
HWY_INLINE hn::Vec<hn::CappedTag<Number, count> > loadApart(const void* base, const std::int32_t* offsets) {
    const hn::CappedTag<Number, count> numbers;
    if constexpr (count == 1) {
        const auto* const from = static_cast<const char*>(base) + (static_cast<std::ptrdiff_t>(*offsets) << shift);
        return hn::LoadU(numbers, reinterpret_cast<const Number*>(from));
    }
#if HWY_TARGET != HWY_SCALAR
    else {
        return hn::Combine(numbers, loadApart<Number, count / 2, shift>(base, offsets + count / 2),
                           loadApart<Number, count / 2, shift>(base, offsets));
    }
#endif
}

template <int shift>
HWY_INLINE IntVector loadDwords(const void* base, IntVector offset) {
    alignas(64) std::int32_t offsets[lanes];
    hn::Store(offset, Ints(), offsets);
    return loadApart<std::int32_t, lanes, shift>(base, offsets);
}
HWY_INLINE FloatVector loadEntries(const float* table, IntVector index) {
    return hn::BitCast(Floats(), loadDwords<2>(table, index));
}

/// Loads four bytes for each active lane, from the cube `offset` cubes after the first and the next cube along x. Other
/// lanes read the first cube.
HWY_INLINE IntVector fourBytes(const std::uint8_t* cubes, IntVector offset, LaneMask active) {
    static_assert(voxelsPerCube == 2);
    return loadDwords<1>(cubes, hn::IfThenElseZero(hn::RebindMask(Ints(), active), offset));
}

/// Two neighbouring dwords in memory for each lane. loadPairs() reads them `offset` times 2^shift bytes after `base`.
struct DwordPair {
    IntVector low, high;
};
HWY_INLINE FloatVector between(FloatVector left, FloatVector right, FloatVector share) {
    return hn::MulAdd(share, hn::Sub(right, left), left);
}

/// Trilinear mean of bytes, in fixed point, with shares of 15 bits along x and z, of 7 bits along y. Samples may read
/// up to 1/128 voxel beside their place. The mean of eight equal bytes is exact. Graphics cards filter with 8 bits
/// along each axis.
constexpr float byteScale = 127.0f * 32767.0f;

HWY_INLINE FloatVector shareOf(IntVector position) {
    return hn::Mul(hn::ConvertTo(Floats(), hn::And(position, set(oneCube - 1))), set(1.0f / oneCube));
}

#if HWY_TARGET == HWY_SCALAR

/// One ray at a time, without vectors. All other routes are compared with this one.
template <int shift>
HWY_INLINE DwordPair loadPairs(const void* base, IntVector offset) {
    std::int32_t pair[2];
    std::memcpy(pair, static_cast<const char*>(base) + (static_cast<std::ptrdiff_t>(offset.raw) << shift),
                sizeof(pair));
    return {set(pair[0]), set(pair[1])};
}

/// Between two numbers, with a share of 15 bits.
HWY_INLINE int fixedBetween(int from, int to, int share) { return from + (((to - from) * share + (1 << 14)) >> 15); }

struct CubeOfBytes {
    const std::uint8_t *near, *far;
    int shareX, shareY, shareZ;
};
HWY_INLINE CubeOfBytes cubeOfBytes(const std::uint8_t* cubes, std::int64_t sliceStride, IntVector offset,
                                   const Position& at, LaneMask active) {
    const auto first = static_cast<std::ptrdiff_t>(hn::IfThenElseZero(hn::RebindMask(Ints(), active), offset).raw);
    const auto share = [](IntVector position) { return (position.raw & 0xFFFF) >> 1; };
    const std::uint8_t* const near = cubes + first * voxelsPerCube;
    return {near, near + sliceStride * voxelsPerCube, share(at.x), share(at.y) >> 8, share(at.z)};
}
HWY_INLINE FloatVector meanOf(const CubeOfBytes& cube) {
    const auto alongY = [&](const std::uint8_t* two) { return two[0] * (127 - cube.shareY) + two[1] * cube.shareY; };
    const auto alongZ = [&](int voxel) {
        const int near = alongY(cube.near + voxel), far = alongY(cube.far + voxel);
        return fixedBetween(near, far, cube.shareZ);
    };
    return set(static_cast<float>(alongZ(0) * (32767 - cube.shareX) + alongZ(voxelsPerCube) * cube.shareX));
}

#else

using Words = hn::Repartition<std::int16_t, Floats>;
using Bytes = hn::Repartition<std::uint8_t, Floats>;

template <int shift>
HWY_INLINE DwordPair loadPairs(const void* base, IntVector offset) {
    const Ints ints;
    alignas(64) std::int32_t offsets[lanes];
    hn::Store(offset, ints, offsets);
    const auto pairs = [&](int first) {
        return hn::BitCast(ints, loadApart<std::int64_t, lanes / 2, shift>(base, offsets + first));
    };
    const auto lower = pairs(0), upper = pairs(lanes / 2);
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
/// The upper 7 bits s below the point, as 127 - s and s in turn.
HWY_INLINE hn::Vec<Bytes> byteShares(IntVector position) {
    alignas(16) static constexpr std::uint8_t pattern[16] = {1, 1, 1, 1, 5, 5, 5, 5, 9, 9, 9, 9, 13, 13, 13, 13};
    const Bytes bytes;
    const Ints ints;
    const auto share = hn::TableLookupBytes(hn::BitCast(bytes, position), hn::LoadDup128(bytes, pattern));
    const auto upper = hn::And(hn::ShiftRight<1>(hn::BitCast(ints, share)), hn::Set(ints, 0x7F7F7F7F));
    return hn::BitCast(bytes, hn::Xor(upper, hn::Set(ints, 0x007F007F)));
}
/// Sums of two neighbouring products.
HWY_INLINE hn::Vec<Words> pairSums(hn::Vec<Bytes> values, hn::Vec<Bytes> shares) {
#if HWY_TARGET == HWY_AVX3
    return hn::Vec<Words>{_mm512_maddubs_epi16(values.raw, shares.raw)};
#elif HWY_TARGET == HWY_AVX2
    return hn::Vec<Words>{_mm256_maddubs_epi16(values.raw, shares.raw)};
#elif HWY_TARGET == HWY_SSE4
    return hn::Vec<Words>{_mm_maddubs_epi16(values.raw, shares.raw)};
#else
    const hn::RebindToUnsigned<Words> bits;
    const Words words;
    const auto low = hn::Set(bits, 0x00FF);
    const auto even = [&](hn::Vec<Bytes> from) { return hn::BitCast(words, hn::And(hn::BitCast(bits, from), low)); };
    const auto odd = [&](hn::Vec<Bytes> from) {
        return hn::BitCast(words, hn::ShiftRight<8>(hn::BitCast(bits, from)));
    };
    return hn::Add(hn::Mul(even(values), even(shares)), hn::Mul(odd(values), odd(shares)));
#endif
}
HWY_INLINE IntVector pairSums(hn::Vec<Words> values, hn::Vec<Words> factors) {
    const Ints ints;
    auto rest = hn::Zero(ints);
    const auto sum = hn::ReorderWidenMulAccumulate(ints, values, factors, hn::Zero(ints), rest);
    return hn::RearrangeToOddPlusEven(sum, rest);
}

/// Between two numbers, with a share of 15 bits.
HWY_INLINE hn::Vec<Words> fixedBetween(hn::Vec<Words> from, hn::Vec<Words> to, hn::Vec<Words> share) {
    return hn::Add(from, hn::MulFixedPoint15(hn::Sub(to, from), share));
}

/// The eight bytes around a position in each lane, and their shares.
struct CubeOfBytes {
    HWY_INLINE CubeOfBytes() {}  // for the same reason as in Run (packet_run-inl.h)
    hn::Vec<Bytes> near, far, shareY;
    hn::Vec<Words> shareX, shareZ;
};
HWY_INLINE CubeOfBytes sharesOf(const Position& at) {
    CubeOfBytes cube;
    cube.shareX = hn::Xor(wordShares(at.x), hn::BitCast(Words(), hn::Set(Ints(), 0x00007FFF)));
    cube.shareY = byteShares(at.y);
    cube.shareZ = wordShares(at.z);
    return cube;
}
HWY_INLINE CubeOfBytes cubeOfBytes(const std::uint8_t* cubes, std::int64_t sliceStride, IntVector offset,
                                   const Position& at, LaneMask active) {
    CubeOfBytes cube = sharesOf(at);
    cube.near = hn::BitCast(Bytes(), fourBytes(cubes, offset, active));
    cube.far = hn::BitCast(Bytes(), fourBytes(cubes + sliceStride * voxelsPerCube, offset, active));
    return cube;
}
HWY_INLINE FloatVector meanOf(const CubeOfBytes& cube) {
    const auto near = pairSums(cube.near, cube.shareY), far = pairSums(cube.far, cube.shareY);
    // The low half of each dword belongs to x, the high half to x + 1.
    const auto slices = fixedBetween(near, far, cube.shareZ);
    return hn::ConvertTo(Floats(), pairSums(slices, cube.shareX));
}

#endif

HWY_INLINE FloatVector meanOfBytes(const std::uint8_t* cubes, std::int64_t sliceStride, IntVector offset,
                                   const Position& at, LaneMask active) {
    return meanOf(cubeOfBytes(cubes, sliceStride, offset, at, active));
}
/// The mean of meanOfBytes(), but in float with shares of 16 bits, as words and floats are interpolated.
HWY_INLINE FloatVector fineMeanOfBytes(const std::uint8_t* cubes, std::int64_t sliceStride, IntVector offset,
                                       const Position& at, LaneMask active) {
    const Floats floats;
    const auto shareX = shareOf(at.x), shareY = shareOf(at.y), shareZ = shareOf(at.z);
    const auto slice = [&](const std::uint8_t* first) {
        const auto four = fourBytes(first, offset, active);
        const auto byte = [&](IntVector from) { return hn::ConvertTo(floats, hn::And(from, set(0xFF))); };
        const auto left = between(byte(four), byte(hn::ShiftRight<8>(four)), shareY);
        const auto right = between(byte(hn::ShiftRight<16>(four)), byte(hn::ShiftRight<24>(four)), shareY);
        return between(left, right, shareX);
    };
    const auto mean = between(slice(cubes), slice(cubes + sliceStride * voxelsPerCube), shareZ);
    return hn::Mul(mean, set(byteScale));
}

/// A volume's cubes counted from a corner.
template <typename Voxel>
struct Cubes {
    const Voxel* cubes;
    const std::uint8_t* presence;  ///< of data; null if data is present everywhere around
    std::int64_t rowStride, sliceStride;

    HWY_INLINE IntVector offsetOf(const Position& at) const {
        const auto cube = hn::ShiftRight<16>(at.x);
#if HWY_TARGET != HWY_SCALAR
        static_assert(rowAlignment == 1 << 4);
        if (sliceStride <= rowAlignment * 32767) {
            // One instruction multiplies and adds both: strides are multiples of rowAlignment.
            const Words words;
            const auto rowAndSlice =
                hn::OddEven(hn::BitCast(words, at.z), hn::BitCast(words, hn::ShiftRight<16>(at.y)));
            const auto strides =
                set(static_cast<std::int32_t>(sliceStride / rowAlignment << 16 | rowStride / rowAlignment));
            return hn::Add(hn::ShiftLeft<4>(pairSums(rowAndSlice, hn::BitCast(words, strides))), cube);
        }
#endif
        const auto row = hn::Mul(hn::ShiftRight<16>(at.y), set(static_cast<std::int32_t>(rowStride)));
        const auto slice = hn::Mul(hn::ShiftRight<16>(at.z), set(static_cast<std::int32_t>(sliceStride)));
        return hn::Add(hn::Add(row, slice), cube);
    }
};

HWY_INLINE FloatVector meanOf(const Cubes<std::uint8_t>& volume, IntVector offset, const Position& at,
                              LaneMask active) {
    return hn::Mul(meanOfBytes(volume.cubes, volume.sliceStride, offset, at, active), set(1.0f / byteScale));
}
/// Lanes without a sample read the corner itself.
HWY_INLINE IntVector withinVolume(IntVector offset, LaneMask active) {
    return hn::IfThenElseZero(hn::RebindMask(Ints(), active), offset);
}
HWY_INLINE FloatVector meanOf(const Cubes<std::uint16_t>& volume, IntVector offset, const Position& at,
                              LaneMask active) {
    offset = withinVolume(offset, active);
    const auto shareX = shareOf(at.x), shareY = shareOf(at.y);
    const auto slice = [&](std::int64_t first) {
        const DwordPair cube = loadPairs<2>(volume.cubes + first * voxelsPerCube, offset);
        const auto above = [](IntVector two) { return hn::ConvertTo(Floats(), hn::And(two, set(0xFFFF))); };
        const auto below = [](IntVector two) {
            const hn::RebindToUnsigned<Ints> bits;
            return hn::ConvertTo(Floats(), hn::BitCast(Ints(), hn::ShiftRight<16>(hn::BitCast(bits, two))));
        };
        return between(between(above(cube.low), above(cube.high), shareX),
                       between(below(cube.low), below(cube.high), shareX), shareY);
    };
    return between(slice(0), slice(volume.sliceStride), shareOf(at.z));
}
HWY_INLINE FloatVector meanOf(const Cubes<float>& volume, IntVector offset, const Position& at, LaneMask active) {
    offset = withinVolume(offset, active);
    const auto shareX = shareOf(at.x), shareY = shareOf(at.y);
    const auto column = [&](std::int64_t first) {
        const DwordPair cube = loadPairs<3>(volume.cubes + first * voxelsPerCube, offset);
        return between(hn::BitCast(Floats(), cube.low), hn::BitCast(Floats(), cube.high), shareY);
    };
    const auto slice = [&](std::int64_t first) { return between(column(first), column(first + 1), shareX); };
    return between(slice(0), slice(volume.sliceStride), shareOf(at.z));
}

/// The presence of data at a place near the data's end, 0 to 1. It is interpolated with the same shares as the voxels.
template <typename Voxel>
HWY_INLINE FloatVector presenceAt(const Cubes<Voxel>& volume, IntVector offset, const Position& at, LaneMask active) {
    constexpr bool bytes = std::is_same_v<Voxel, std::uint8_t>;
    const auto sum = bytes ? meanOfBytes(volume.presence, volume.sliceStride, offset, at, active)
                           : fineMeanOfBytes(volume.presence, volume.sliceStride, offset, at, active);
    return hn::Mul(sum, set(1.0f / (byteScale * 255.0f)));
}
/// PresenceUse::coverage(). For the nearest voxel all or nothing.
HWY_INLINE FloatVector coverageOf(FloatVector presence, bool nearest) {
    const auto zero = set(0.0f), one = set(1.0f);
    if (nearest) return hn::IfThenElseZero(hn::Ge(presence, set(0.5f)), one);
    return hn::Min(hn::Max(hn::MulAdd(presence, set(2.0f), set(-0.5f)), zero), one);
}
/// PresenceUse::border().
HWY_INLINE FloatVector borderOf(FloatVector presence) {
    const auto share = hn::Mul(hn::Sub(set(0.875f), presence), set(1.0f / 0.375f));
    return hn::Min(hn::Max(share, set(0.0f)), set(1.0f));
}

/// Moves each component to the nearest voxel, which is the lower one of the cube at the new position.
HWY_INLINE Position nearestVoxel(const Position& at) {
    const auto round = [](IntVector value) { return hn::And(hn::Add(value, set(oneCube / 2)), set(~(oneCube - 1))); };
    return {round(at.x), round(at.y), round(at.z)};
}

/// Table positions, 0 ... intervals, of values.
template <typename Voxel>
HWY_INLINE FloatVector tablePositionOf(FloatVector value, float toTable) {
    const auto position = hn::Min(hn::Mul(value, set(toTable)), set(static_cast<float>(TransferTable::intervals)));
    return std::is_same_v<Voxel, float> ? hn::Max(position, set(0.0f)) : position;
}
template <typename Voxel>
HWY_INLINE FloatVector tablePositionAt(const Cubes<Voxel>& volume, const Position& at, float toTable, LaneMask active) {
    return tablePositionOf<Voxel>(meanOf(volume, volume.offsetOf(at), at, active), toTable);
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
