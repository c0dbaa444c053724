// A short piece of a tube core, counted from a voxel near it. meanSlabs() hands it to the vector code.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace echolucent::tube_slabs {

/// The most slabs in one piece, and the most lanes of one vector.
inline constexpr int pieceLength = 16;

/// Positions are fixed-point numbers with positionBits binary places. So sums are exact, and a shift splits a position
/// into a cell and the share within it.
inline constexpr int positionBits = 16;
inline constexpr std::int32_t oneVoxel = 1 << positionBits;

/// Offsets of a slab's samples from its axis, fixed point; the same for all slabs of a view.
struct SlabPattern {
    std::vector<std::int32_t> x, y, z;
};

/// Where the samples of all slabs in a piece may reach.
enum class Surroundings {
    complete,  ///< all voxels around exist, carry data and have three more behind them in memory
    any,
};

/// Up to pieceLength slabs of one tube. Positions are counted from the voxel at `first`, fixed point.
template <typename Voxel>
struct Piece {
    const Voxel* first = nullptr;
    const std::uint8_t* mask = nullptr;               ///< of the voxel at `first`; null if all voxels are data
    std::int32_t rowStride = 0, sliceStride = 0;      ///< in voxels; 0 along an axis of one voxel
    std::array<std::int32_t, 3> lowest{}, highest{};  ///< the outermost voxels' positions
    std::array<std::int32_t, 3> lastCell{};           ///< the last cell with a voxel on each side
    std::int32_t lastWord = 0;  ///< offset in voxels of a byte: the last place from which four bytes can be read
    float white = 1.0f;         ///< intensity 1: stored value times scale
    float scale = 1.0f;         ///< for float voxels: a power of two, see slabScale()
    alignas(64) std::array<std::int32_t, pieceLength> x{}, y{}, z{};  ///< positions of the slabs on the axis; entries
                                                                      ///< beyond the last slab repeat it
    int slabs = 0;
};

/// One value for each slab of the piece.
struct PieceMoments {
    alignas(64) std::array<float, pieceLength> counts, means, squaredDeviations;
};

/// How a piece is read.
struct PieceRoute {
    bool nearest = false;
    Surroundings surroundings = Surroundings::any;
};

/// Fills the moments of the piece's slabs (entries beyond them are arbitrary).
template <typename Voxel>
void momentsOf(const Piece<Voxel>& piece, const SlabPattern& pattern, const PieceRoute& route, PieceMoments& moments);

}  // namespace echolucent::tube_slabs
