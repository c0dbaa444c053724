// Means of blocks of voxels, gathered slice by slice, so that memory never holds all the voxels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "processing/volume/reduction.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A type for sums of values, so wide that no block overflows it.
template <typename T>
struct BlockSum {
    static constexpr bool isExact = std::is_integral_v<T> && sizeof(T) <= 4;
    using WholeSum = std::conditional_t<sizeof(T) == 1, std::int32_t, std::int64_t>;
    using Type = std::conditional_t<isExact, WholeSum, std::conditional_t<sizeof(T) == 4, double, long double>>;
};

/// Writes the mean of every block as the slices of one volume arrive. Means of whole numbers are rounded, halves
/// upwards. Values that are not finite do not count; a block without finite values becomes NaN. T is one of std::int8_t
/// to std::uint64_t, float and double.
template <typename T>
class BlockMean {
public:
    /// `reduced` takes the means, x fastest, and must outlive this object. Its size is the product of reducedSize();
    /// any other is a broken contract (std::invalid_argument).
    BlockMean(const Reduction& reduction, std::span<T> reduced);

    /// Takes the next slice along z: storedSize[0] * storedSize[1] values, x fastest. Another number of values, or a
    /// slice beyond the last, is a broken contract (std::invalid_argument).
    void add(std::span<const T> slice);
    /// Passes over the next slice, because it could not be read. The slice does not count. A layer of blocks made only
    /// of such slices becomes 0. A slice beyond the last is a broken contract (std::invalid_argument).
    void skip();

private:
    using Sum = typename BlockSum<T>::Type;

    void endSlice();
    /// The first stored voxel of a block along an axis, and the one behind its last.
    [[nodiscard]] std::array<std::int64_t, 2> voxelsOf(std::size_t axis, std::int64_t block) const;
    [[nodiscard]] T meanOf(std::size_t firstColumn, std::int64_t x, std::int64_t valuesAlongYz) const;

    Reduction m_reduction;
    std::array<std::int64_t, 3> m_lacking;  // lackingInFirst()
    std::span<T> m_reduced;
    // The present layer of blocks: sums along y and z, one for each column of x, and for floating-point types the
    // numbers of finite values.
    std::vector<Sum> m_sums;
    std::vector<std::uint32_t> m_counts;
    std::int64_t m_slice = 0;    // slices added or passed over so far
    std::int64_t m_counted = 0;  // slices of the present layer that count
    std::size_t m_written = 0;   // means written so far
};

/// The geometry of the means: the size of the blocks' grid, the spacing times the factors, and the origin at the centre
/// of the first block. So every whole block stands where its voxels stood. A block that holds fewer voxels stands like
/// a whole one. The probe keeps its place. `stored` describes the file's voxels; its size is the reduction's
/// storedSize.
[[nodiscard]] VolumeGeometry reducedGeometry(const VolumeGeometry& stored, const Reduction& reduction);

}  // namespace echolucent
