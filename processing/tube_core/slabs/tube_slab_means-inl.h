// Interpolated samples of a piece of a tube core, as Highway vectors. Compiled once for each instruction set.
#include <type_traits>

#include "processing/tube_core/slabs/tube_slab_means.h"

#include <hwy/highway.h>

#if defined(ECHOLUCENT_TUBE_SLAB_MEANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_TUBE_SLAB_MEANS_INL
#undef ECHOLUCENT_TUBE_SLAB_MEANS_INL
#else
#define ECHOLUCENT_TUBE_SLAB_MEANS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::tube_slabs::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, pieceLength>;
using Ints = hn::RebindToSigned<Floats>;
using FloatVector = hn::Vec<Floats>;
using IntVector = hn::Vec<Ints>;
using FloatMask = hn::Mask<Floats>;

/// Bytes are blended along x in integers, with weights of byteWeightBits binary places. This is exact and takes few
/// instructions.
constexpr int byteWeightBits = 14;

/// Multiplies blended values to give stored values.
template <typename Voxel>
constexpr float storedScale = sizeof(Voxel) == 1 ? 1.0f / (1 << byteWeightBits) : 1.0f;

HWY_INLINE FloatVector between(FloatVector left, FloatVector right, FloatVector share) {
    return hn::Add(left, hn::Mul(share, hn::Sub(right, left)));
}

struct Position {
    IntVector x, y, z;
};

/// The cell of a position: offset of its first voxel, and the weights of its far side.
struct Cell {
    IntVector offset;  ///< voxels
    IntVector shareX;  ///< fixed point; for bytes the two weights that blendBytes() takes
    FloatVector partX, shareY, shareZ;
};

/// The word of four bytes from each offset on. careful: near the array's end, only the bytes that exist.
template <bool careful>
HWY_INLINE IntVector bytesAt(const std::uint8_t* first, IntVector offset, std::int32_t lastWord) {
    const Ints ints;
    const auto* words = reinterpret_cast<const std::int32_t*>(first);
    if constexpr (!careful) return hn::GatherOffset(ints, words, offset);
    const hn::RebindToUnsigned<Ints> unsignedInts;
    const auto from = hn::Min(offset, hn::Set(ints, lastWord));
    const auto word = hn::BitCast(unsignedInts, hn::GatherOffset(ints, words, from));
    const auto bits = hn::BitCast(unsignedInts, hn::ShiftLeft<3>(hn::Sub(offset, from)));
    return hn::BitCast(ints, hn::Shr(word, bits));
}

/// First byte times the low half of the weights plus second byte times their high half, exact.
HWY_INLINE FloatVector blendBytes(IntVector words, IntVector weights) {
    const Ints ints;
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR
    const hn::Repartition<std::uint8_t, Ints> bytes;
    const hn::Repartition<std::int16_t, Ints> shorts;
    alignas(16) static constexpr std::uint8_t spread[16] = {0, 0x80, 1, 0x80, 4,  0x80, 5,  0x80,
                                                            8, 0x80, 9, 0x80, 12, 0x80, 13, 0x80};
    const auto pairs = hn::TableLookupBytesOr0(hn::BitCast(bytes, words), hn::LoadDup128(bytes, spread));
    auto unused = hn::Zero(ints);
    return hn::ConvertTo(Floats(), hn::ReorderWidenMulAccumulate(ints, hn::BitCast(shorts, pairs),
                                                                 hn::BitCast(shorts, weights), hn::Zero(ints), unused));
#else
    const auto byte = hn::Set(ints, 0xFF), half = hn::Set(ints, 0xFFFF);
    const auto left = hn::Mul(hn::And(words, byte), hn::And(weights, half));
    const auto right = hn::Mul(hn::And(hn::ShiftRight<8>(words), byte), hn::And(hn::ShiftRight<16>(weights), half));
    return hn::ConvertTo(Floats(), hn::Add(left, right));
#endif
}

/// The value times scale, limited to 0 ... white level. NaN becomes 0.
HWY_INLINE FloatVector limited(FloatVector value, const Piece<float>& piece) {
    const Floats floats;
    const auto scaled = hn::Mul(value, hn::Set(floats, piece.scale));
    return hn::IfThenElseZero(hn::Gt(scaled, hn::Zero(floats)), hn::Min(scaled, hn::Set(floats, piece.white)));
}

/// The blend along x of two voxels: the one at the cell's offset plus `shift`, and the next one in memory.
template <typename Voxel, bool careful>
HWY_INLINE FloatVector pairAt(const Piece<Voxel>& piece, std::ptrdiff_t shift, const Cell& cell) {
    const Floats floats;
    const Ints ints;
    const Voxel* first = piece.first + shift;
    if constexpr (sizeof(Voxel) == 1) {
        return blendBytes(bytesAt<careful>(first, cell.offset, piece.lastWord - static_cast<std::int32_t>(shift)),
                          cell.shareX);
    } else if constexpr (std::is_same_v<Voxel, float>) {
        const auto bytes = hn::ShiftLeft<2>(cell.offset);
        return between(limited(hn::GatherOffset(floats, first, bytes), piece),
                       limited(hn::GatherOffset(floats, first + 1, bytes), piece), cell.partX);
    } else {
        const auto words =
            hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(first), hn::ShiftLeft<1>(cell.offset));
        const auto white = hn::Set(floats, piece.white);
        const auto half = hn::Set(ints, 0xFFFF);
        return between(hn::Min(hn::ConvertTo(floats, hn::And(words, half)), white),
                       hn::Min(hn::ConvertTo(floats, hn::And(hn::ShiftRight<16>(words), half)), white), cell.partX);
    }
}

/// As pairAt(), of the mask: 1 if every voxel with a share carries data, else less.
template <typename Voxel>
HWY_INLINE FloatVector dataAt(const Piece<Voxel>& piece, std::int32_t shift, const Cell& cell) {
    const Floats floats;
    const Ints ints;
    const auto words = bytesAt<true>(piece.mask + shift, cell.offset, piece.lastWord - shift);
    const auto dataIn = [&](std::int32_t bits) {
        const auto has = hn::RebindMask(floats, hn::Ne(hn::And(words, hn::Set(ints, bits)), hn::Zero(ints)));
        return hn::IfThenElseZero(has, hn::Set(floats, 1.0f));
    };
    return between(dataIn(0xFF), dataIn(0xFF00), cell.partX);
}

template <bool careful>
HWY_INLINE IntVector cellOf(IntVector position, std::int32_t lastCell) {
    const auto cell = hn::ShiftRight<positionBits>(position);
    if constexpr (careful) return hn::Min(cell, hn::Set(Ints(), lastCell));
    return cell;
}

HWY_INLINE FloatVector partOf(IntVector share) {
    const Floats floats;
    return hn::Mul(hn::ConvertTo(floats, share), hn::Set(floats, 1.0f / oneVoxel));
}

template <typename Voxel>
HWY_INLINE IntVector offsetOf(const Piece<Voxel>& piece, IntVector x, IntVector y, IntVector z) {
    const Ints ints;
    return hn::Add(hn::Add(x, hn::Mul(y, hn::Set(ints, piece.rowStride))),
                   hn::Mul(z, hn::Set(ints, piece.sliceStride)));
}

template <typename Voxel, bool careful>
HWY_INLINE Cell cellAt(const Piece<Voxel>& piece, const Position& position) {
    const Ints ints;
    const auto x = cellOf<careful>(position.x, piece.lastCell[0]), y = cellOf<careful>(position.y, piece.lastCell[1]);
    const auto z = cellOf<careful>(position.z, piece.lastCell[2]);
    const auto share = [](IntVector at, IntVector cell) {
        // The last cell includes its far side. There the share is a whole voxel.
        if constexpr (careful) return hn::Sub(at, hn::ShiftLeft<positionBits>(cell));
        return hn::And(at, hn::Set(Ints(), oneVoxel - 1));
    };
    Cell cell{offsetOf(piece, x, y, z), share(position.x, x), hn::Zero(Floats()), partOf(share(position.y, y)),
              partOf(share(position.z, z))};
    if constexpr (sizeof(Voxel) == 1) {
        const auto far = hn::ShiftRight<positionBits - byteWeightBits>(cell.shareX);
        if constexpr (careful)
            cell.partX = hn::Mul(hn::ConvertTo(Floats(), far), hn::Set(Floats(), storedScale<std::uint8_t>));
        const auto near = hn::Sub(hn::Set(ints, 1 << byteWeightBits), far);
        cell.shareX = hn::Add(hn::ShiftLeft<16>(far), near);
    } else {
        cell.partX = partOf(cell.shareX);
    }
    return cell;
}

template <typename Voxel, bool careful>
HWY_INLINE FloatVector trilinear(const Piece<Voxel>& piece, const Cell& cell) {
    const std::ptrdiff_t row = piece.rowStride, slice = piece.sliceStride;
    const auto front =
        between(pairAt<Voxel, careful>(piece, 0, cell), pairAt<Voxel, careful>(piece, row, cell), cell.shareY);
    const auto back = between(pairAt<Voxel, careful>(piece, slice, cell),
                              pairAt<Voxel, careful>(piece, slice + row, cell), cell.shareY);
    return between(front, back, cell.shareZ);
}

/// Whether every voxel with a share carries data.
template <typename Voxel>
HWY_INLINE FloatMask completeAt(const Piece<Voxel>& piece, const Cell& cell) {
    const std::int32_t row = piece.rowStride, slice = piece.sliceStride;
    const auto front = between(dataAt(piece, 0, cell), dataAt(piece, row, cell), cell.shareY);
    const auto back = between(dataAt(piece, slice, cell), dataAt(piece, slice + row, cell), cell.shareY);
    return hn::Ge(between(front, back, cell.shareZ), hn::Set(Floats(), 1.0f));
}

/// Offset of the nearest voxel. Half way between two voxels, the one with the higher index counts.
template <typename Voxel>
HWY_INLINE IntVector nearestOffset(const Piece<Voxel>& piece, const Position& position) {
    const auto nearest = [](IntVector at) {
        return hn::ShiftRight<positionBits>(hn::Add(at, hn::Set(Ints(), oneVoxel / 2)));
    };
    return offsetOf(piece, nearest(position.x), nearest(position.y), nearest(position.z));
}

template <typename Voxel, bool careful>
HWY_INLINE FloatVector voxelAt(const Piece<Voxel>& piece, IntVector offset) {
    const Floats floats;
    const Ints ints;
    if constexpr (sizeof(Voxel) == 1) {
        const auto byte = hn::And(bytesAt<careful>(piece.first, offset, piece.lastWord), hn::Set(ints, 0xFF));
        return hn::ConvertTo(floats, hn::ShiftLeft<byteWeightBits>(byte));
    } else if constexpr (std::is_same_v<Voxel, float>) {
        return limited(hn::GatherOffset(floats, piece.first, hn::ShiftLeft<2>(offset)), piece);
    } else {
        // The last voxel has no next one, so it is read from the word that ends with it.
        const auto last = hn::Set(ints, piece.lastWord + 2);
        const auto from = hn::Min(offset, last);
        const auto words =
            hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(piece.first), hn::ShiftLeft<1>(from));
        const auto half = hn::Set(ints, 0xFFFF);
        const auto word =
            hn::IfThenElse(hn::Gt(offset, last), hn::And(hn::ShiftRight<16>(words), half), hn::And(words, half));
        return hn::Min(hn::ConvertTo(floats, word), hn::Set(floats, piece.white));
    }
}

template <typename Voxel>
HWY_INLINE FloatMask hasDataAt(const Piece<Voxel>& piece, IntVector offset) {
    const Ints ints;
    const auto byte = hn::And(bytesAt<true>(piece.mask, offset, piece.lastWord), hn::Set(ints, 0xFF));
    return hn::RebindMask(Floats(), hn::Gt(byte, hn::Zero(ints)));
}

struct Sample {
    FloatVector value;
    FloatMask valid;
};

template <typename Voxel, bool nearest>
HWY_INLINE FloatVector completeSample(const Piece<Voxel>& piece, const Position& position) {
    if constexpr (nearest) return voxelAt<Voxel, false>(piece, nearestOffset(piece, position));
    return trilinear<Voxel, false>(piece, cellAt<Voxel, false>(piece, position));
}

/// Clamps positions along one axis into the volume. Returns which positions were inside. Positions up to half a voxel
/// outside count as inside.
HWY_INLINE hn::Mask<Ints> clampInto(IntVector& position, std::int32_t lowest, std::int32_t highest) {
    const Ints ints;
    const auto inside = hn::And(hn::Gt(position, hn::Set(ints, lowest - oneVoxel / 2 - 1)),
                                hn::Lt(position, hn::Set(ints, highest + oneVoxel / 2 + 1)));
    position = hn::Min(hn::Max(position, hn::Set(ints, lowest)), hn::Set(ints, highest));
    return inside;
}

template <typename Voxel, bool nearest>
HWY_INLINE Sample carefulSample(const Piece<Voxel>& piece, Position position) {
    auto inside = clampInto(position.x, piece.lowest[0], piece.highest[0]);
    inside = hn::And(inside, clampInto(position.y, piece.lowest[1], piece.highest[1]));
    inside = hn::And(inside, clampInto(position.z, piece.lowest[2], piece.highest[2]));
    const auto valid = hn::RebindMask(Floats(), inside);
    const auto at = nearestOffset(piece, position);
    if constexpr (nearest) {
        const auto value = voxelAt<Voxel, true>(piece, at);
        if (piece.mask == nullptr) return {value, valid};
        return {value, hn::And(valid, hasDataAt(piece, at))};
    }
    const Cell cell = cellAt<Voxel, true>(piece, position);
    const auto value = trilinear<Voxel, true>(piece, cell);
    if (piece.mask == nullptr) return {value, valid};
    const auto complete = completeAt(piece, cell);
    return {hn::IfThenElse(complete, value, voxelAt<Voxel, true>(piece, at)),
            hn::And(valid, hn::Or(complete, hasDataAt(piece, at)))};
}

/// Deviations are counted from each slab's first sample: they are small, and 0 if all samples are equal.
template <typename Voxel>
HWY_INLINE void store(FloatVector count, FloatVector origin, FloatVector sum, FloatVector squares, int lane,
                      PieceMoments& moments) {
    const Floats floats;
    const auto scale = hn::Set(floats, storedScale<Voxel>);
    const auto some = hn::Gt(count, hn::Zero(floats));
    const auto offset = hn::Div(sum, hn::IfThenElse(some, count, hn::Set(floats, 1.0f)));
    hn::Store(count, floats, moments.counts.data() + lane);
    hn::Store(hn::IfThenElseZero(some, hn::Mul(hn::Add(origin, offset), scale)), floats, moments.means.data() + lane);
    const auto deviations = hn::Max(hn::Sub(squares, hn::Mul(sum, offset)), hn::Zero(floats));
    hn::Store(hn::Mul(hn::Mul(deviations, scale), scale), floats, moments.squaredDeviations.data() + lane);
}

template <typename Voxel, bool nearest, bool careful>
HWY_INLINE void sumPiece(const Piece<Voxel>& piece, const SlabPattern& pattern, PieceMoments& moments) {
    const Floats floats;
    const Ints ints;
    const std::size_t samples = pattern.x.size();
    const auto one = hn::Set(floats, 1.0f);
    for (int lane = 0; lane < piece.slabs; lane += static_cast<int>(hn::Lanes(floats))) {
        const auto x = hn::Load(ints, piece.x.data() + lane), y = hn::Load(ints, piece.y.data() + lane);
        const auto z = hn::Load(ints, piece.z.data() + lane);
        auto count = hn::Zero(floats), sum = hn::Zero(floats), squares = hn::Zero(floats), origin = hn::Zero(floats);
        for (std::size_t i = 0; i < samples; ++i) {
            const Position position{hn::Add(x, hn::Set(ints, pattern.x[i])), hn::Add(y, hn::Set(ints, pattern.y[i])),
                                    hn::Add(z, hn::Set(ints, pattern.z[i]))};
            FloatVector deviation;
            if constexpr (careful) {
                const Sample sample = carefulSample<Voxel, nearest>(piece, position);
                const auto isFirst = hn::And(sample.valid, hn::Eq(count, hn::Zero(floats)));
                origin = hn::IfThenElse(isFirst, sample.value, origin);
                deviation = hn::IfThenElseZero(sample.valid, hn::Sub(sample.value, origin));
                count = hn::Add(count, hn::IfThenElseZero(sample.valid, one));
            } else {
                const auto value = completeSample<Voxel, nearest>(piece, position);
                if (i == 0) origin = value;
                deviation = hn::Sub(value, origin);
            }
            sum = hn::Add(sum, deviation);
            squares = hn::Add(squares, hn::Mul(deviation, deviation));
        }
        if constexpr (!careful) count = hn::Set(floats, static_cast<float>(samples));
        store<Voxel>(count, origin, sum, squares, lane, moments);
    }
}

template <typename Voxel, bool nearest>
HWY_INLINE void sumPieceIn(Surroundings surroundings, const Piece<Voxel>& piece, const SlabPattern& pattern,
                           PieceMoments& moments) {
    if (surroundings == Surroundings::complete)
        sumPiece<Voxel, nearest, false>(piece, pattern, moments);
    else
        sumPiece<Voxel, nearest, true>(piece, pattern, moments);
}

template <typename Voxel>
HWY_INLINE void sumPieceBy(const Piece<Voxel>& piece, const SlabPattern& pattern, const PieceRoute& route,
                           PieceMoments& moments) {
    if (route.nearest)
        sumPieceIn<Voxel, true>(route.surroundings, piece, pattern, moments);
    else
        sumPieceIn<Voxel, false>(route.surroundings, piece, pattern, moments);
}

}  // namespace echolucent::tube_slabs::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
