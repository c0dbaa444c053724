#include "processing/volume/block_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace echolucent {

namespace {

static_assert(largestReduction * largestReduction * largestReduction <= std::numeric_limits<std::int32_t>::max() / 256,
              "the bytes of a block must not overflow their sum");

/// The mean of `count` whole numbers (above 0) with this sum, halves rounded upwards.
std::int64_t roundedMean(std::int64_t sum, std::int64_t count) {
    const std::int64_t doubled = 2 * sum + count, divisor = 2 * count;
    return doubled / divisor - (doubled % divisor < 0 ? 1 : 0);
}

}  // namespace

template <typename T>
BlockMean<T>::BlockMean(const Reduction& reduction, std::span<T> reduced)
    : m_reduction(reduction), m_lacking(lackingInFirst(reduction)), m_reduced(reduced) {
    const auto size = reducedSize(reduction);
    if (static_cast<std::uint64_t>(size[0] * size[1] * size[2]) != reduced.size())
        throw std::invalid_argument("BlockMean: the means do not fit the reduction");
    const auto columns = static_cast<std::size_t>(reduction.storedSize[0] * size[1]);
    m_sums.resize(columns);
    if constexpr (std::is_floating_point_v<T>) m_counts.resize(columns);
}

template <typename T>
void BlockMean<T>::add(std::span<const T> slice) {
    const auto width = static_cast<std::size_t>(m_reduction.storedSize[0]);
    const auto rows = static_cast<std::size_t>(m_reduction.storedSize[1]);
    if (slice.size() != width * rows || m_slice >= m_reduction.storedSize[2])
        throw std::invalid_argument("BlockMean: a slice of another volume");
    const auto rowsOfBlock = static_cast<std::size_t>(m_reduction.by[1]);
    const auto lackingRows = static_cast<std::size_t>(m_lacking[1]);
    for (std::size_t y = 0; y < rows; ++y) {
        const T* row = slice.data() + y * width;
        const std::size_t columns = (y + lackingRows) / rowsOfBlock * width;
        Sum* sums = m_sums.data() + columns;
        if constexpr (std::is_floating_point_v<T>) {
            std::uint32_t* counts = m_counts.data() + columns;
            for (std::size_t x = 0; x < width; ++x) {
                const bool isFinite = std::isfinite(row[x]);
                sums[x] += isFinite ? static_cast<Sum>(row[x]) : Sum{0};
                counts[x] += isFinite ? 1 : 0;
            }
        } else {
            for (std::size_t x = 0; x < width; ++x) sums[x] += static_cast<Sum>(row[x]);
        }
    }
    ++m_counted;
    endSlice();
}

template <typename T>
void BlockMean<T>::skip() {
    if (m_slice >= m_reduction.storedSize[2]) throw std::invalid_argument("BlockMean: a slice of another volume");
    endSlice();
}

template <typename T>
std::array<std::int64_t, 2> BlockMean<T>::voxelsOf(std::size_t axis, std::int64_t block) const {
    const std::int64_t begin = block * m_reduction.by[axis] - m_lacking[axis];
    return {std::max(begin, std::int64_t{0}), std::min(begin + m_reduction.by[axis], m_reduction.storedSize[axis])};
}

template <typename T>
T BlockMean<T>::meanOf(std::size_t firstColumn, std::int64_t x, std::int64_t valuesAlongYz) const {
    const auto [begin, end] = voxelsOf(0, x);
    Sum sum = 0;
    std::int64_t count = (end - begin) * valuesAlongYz;
    for (std::int64_t column = begin; column < end; ++column)
        sum += m_sums[firstColumn + static_cast<std::size_t>(column)];
    if constexpr (std::is_floating_point_v<T>) {
        count = 0;
        for (std::int64_t column = begin; column < end; ++column)
            count += m_counts[firstColumn + static_cast<std::size_t>(column)];
        return count > 0 ? static_cast<T>(sum / static_cast<Sum>(count)) : std::numeric_limits<T>::quiet_NaN();
    } else if constexpr (BlockSum<T>::isExact) {
        return static_cast<T>(roundedMean(sum, count));
    } else {
        // `mean` is rounded, so it may lie above the largest value of the type. Do not convert such a value.
        const Sum mean = sum / static_cast<Sum>(count), whole = std::floor(mean);
        if (mean >= static_cast<Sum>(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
        return static_cast<T>(mean - whole < Sum{0.5} ? whole : whole + 1);
    }
}

template <typename T>
void BlockMean<T>::endSlice() {
    ++m_slice;
    if ((m_slice + m_lacking[2]) % m_reduction.by[2] != 0 && m_slice != m_reduction.storedSize[2]) return;
    const auto size = reducedSize(m_reduction);
    for (std::int64_t y = 0; y < size[1]; ++y) {
        const auto [firstRow, endOfRows] = voxelsOf(1, y);
        const auto firstColumn = static_cast<std::size_t>(y * m_reduction.storedSize[0]);
        for (std::int64_t x = 0; x < size[0]; ++x)
            m_reduced[m_written++] = m_counted > 0 ? meanOf(firstColumn, x, (endOfRows - firstRow) * m_counted) : T{0};
    }
    std::ranges::fill(m_sums, Sum{0});
    std::ranges::fill(m_counts, 0U);
    m_counted = 0;
}

template class BlockMean<std::int8_t>;
template class BlockMean<std::uint8_t>;
template class BlockMean<std::int16_t>;
template class BlockMean<std::uint16_t>;
template class BlockMean<std::int32_t>;
template class BlockMean<std::uint32_t>;
template class BlockMean<std::int64_t>;
template class BlockMean<std::uint64_t>;
template class BlockMean<float>;
template class BlockMean<double>;

VolumeGeometry reducedGeometry(const VolumeGeometry& stored, const Reduction& reduction) {
    VolumeGeometry geometry = stored;
    geometry.size = reducedSize(reduction);
    const auto lacking = lackingInFirst(reduction);
    Vec3 firstCentre;  // in stored voxels
    for (int axis = 0; axis < 3; ++axis) {
        const auto factor = static_cast<double>(reduction.by[static_cast<std::size_t>(axis)]);
        geometry.spacing[axis] *= factor;
        firstCentre[axis] = (factor - 1) / 2 - static_cast<double>(lacking[static_cast<std::size_t>(axis)]);
    }
    geometry.origin = stored.patientFromVoxel(firstCentre);
    if (geometry.probe && geometry.probe->apexMm) *geometry.probe->apexMm -= stored.gridMmFromVoxel(firstCentre);
    geometry.reduction = reduction;
    return geometry;
}

}  // namespace echolucent
