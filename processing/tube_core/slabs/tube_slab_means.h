// What meanSlabs() hands to the vector code: a short piece of a tube core, counted from a voxel near it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace echolucent::tube_slabs {

/// Slabs in one piece at most, and one vector's lanes at most.
inline constexpr int pieceLength = 16;

/// Positions are fixed-point numbers with positionBits binary places, so that sums are exact and a shift gives a cell
/// and its share.
inline constexpr int positionBits = 16;
inline constexpr std::int32_t oneVoxel = 1 << positionBits;

/// Samples of a slab beside its axis, fixed point; the same for all slabs of a view.
struct SlabPattern {
    std::vector<std::int32_t> x, y, z;
};

/// Where the samples of all slabs in a piece may reach.
enum class Surroundings {
    complete,  ///< all voxels around exist, carry data and have three more behind them in memory
    any,
};

/// Up to pieceLength slabs of one tube. Positions are counted from `first`, a voxel of the volume, in fixed point.
template <typename Voxel>
struct Piece {
    const Voxel* first = nullptr;
    const std::uint8_t* mask = nullptr;               ///< of the voxel at `first`; null where all are data
    std::int32_t rowStride = 0, sliceStride = 0;      ///< voxels; 0 along an axis of one voxel
    std::array<std::int32_t, 3> lowest{}, highest{};  ///< the outermost voxels' positions
    std::array<std::int32_t, 3> lastCell{};           ///< the last cell with a voxel on either side
    std::int32_t lastWord = 0;  ///< offset of the last voxel from which four bytes can be read, voxels of a byte
    float white = 1.0f;         ///< intensity 1: stored value times scale
    float scale = 1.0f;         ///< of float voxels: a power of two, see slabScale()
    alignas(64) std::array<std::int32_t, pieceLength> x{}, y{}, z{};  ///< of the slabs' axis points; beyond the last
                                                                      ///< slab the last one's again
    int slabs = 0;
};

/// One value a slab of the piece.
struct PieceMoments {
    alignas(64) std::array<float, pieceLength> counts, means, squaredDeviations;
};

/// How a piece is to be read.
struct PieceRoute {
    bool nearest = false;
    Surroundings surroundings = Surroundings::any;
};

/// Fills the moments of the piece's slabs (entries beyond them are arbitrary).
template <typename Voxel>
void momentsOf(const Piece<Voxel>& piece, const SlabPattern& pattern, const PieceRoute& route, PieceMoments& moments);

}  // namespace echolucent::tube_slabs
