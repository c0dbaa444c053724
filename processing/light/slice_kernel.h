// The innermost loop of a sweep: light goes from one slice of a grid to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace echolucent::light {

/// One of the directions that are swept together. Planes have a rim of one place on all sides, in which all light
/// reaches: place (column, row) stands at (row + 1) * planeStride + column + 1.
struct SweptDirection {
    float taps[4];       ///< shares of places (0,0), (1,0), (0,1), (1,1) from (column, row) on
    int column, row;     ///< -1 or 0: the first of these places in the plane before, from a place's own on
    float halfLengthMm;  ///< half the way from slice to slice
    float weight;
    const float* before;  ///< light behind the slice before
    float* behind;        ///< light behind this slice
};

struct SliceJob {
    const float* extinctions;  ///< per mm, of place (0,0) of the slice
    std::size_t rowStride;     ///< between rows of extinctions and of `reaching`
    int columns, rows;
    std::size_t planeStride;
    std::span<const SweptDirection> directions;
    float* sums;              ///< room for a row of the plane
    std::uint16_t* reaching;  ///< the weighted sum of what reaches the places, as shares of `scale`
    float scale;
};

/// Floats that may be read behind the last extinction, and columns that a plane and a row of sums have to spare.
inline constexpr std::size_t spareFloats = 16;

void sweepSlice(const SliceJob& job);

}  // namespace echolucent::light
