// The innermost loop of a sweep: light goes from one slice of a grid to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace echolucent::light {

/// One of the directions that are swept together. Planes have a rim of one place on all sides, which all light reaches.
/// Place (column, row) stands at (row + 1) * planeStride + column + 1.
struct SweptDirection {
    float taps[4];    ///< shares of the places at (column, row) + (0,0), (1,0), (0,1), (1,1)
    int column, row;  ///< -1 or 0: the way from a place to the first of the four places of `taps` in the plane before
    float halfLengthMm;  ///< half the way from slice to slice
    float weight;
    const float* before;  ///< light behind the slice before
    float* behind;        ///< light behind this slice
};

struct SliceJob {
    const float* extinctions;  ///< per mm, of place (0,0) of the slice
    std::size_t rowStride;     ///< between rows of extinctions, and between rows of `reaching`
    int columns, rows;
    std::size_t planeStride;
    std::span<const SweptDirection> directions;
    float* sums;              ///< room for a row of the plane
    std::uint16_t* reaching;  ///< the weighted sum of light that reaches the places; `scale` is all light
    float scale;
};

/// Floats that may be read behind the last extinction, and columns that a plane and a row of sums have to spare.
inline constexpr std::size_t spareFloats = 16;

void sweepSlice(const SliceJob& job);

}  // namespace echolucent::light
