// Marks parts of a volume's rows, such as those that a stroke of the scalpel changed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// Voxels [first, last) of a row along x; none if first is not below last.
struct RowPart {
    std::int32_t first = 0, last = 0;

    [[nodiscard]] bool any() const { return first < last; }
    [[nodiscard]] std::int64_t count() const { return any() ? last - first : 0; }
    /// The smallest part that holds both.
    [[nodiscard]] RowPart joined(const RowPart& other) const {
        if (!any() || !other.any()) return any() ? *this : other;
        return {std::min(first, other.first), std::max(last, other.last)};
    }
};

/// One part for each of a grid's rows along x.
class RowMarks {
public:
    explicit RowMarks(const std::array<std::int64_t, 3>& size, bool all = false)
        : m_columns(static_cast<std::int32_t>(size[0])),
          m_rows(size[1]),
          m_slices(size[2]),
          m_parts(static_cast<std::size_t>(m_rows * m_slices), all ? RowPart{0, m_columns} : RowPart{}) {}

    [[nodiscard]] std::int64_t rows() const { return m_rows; }      ///< in a slice, along y
    [[nodiscard]] std::int64_t slices() const { return m_slices; }  ///< along z
    [[nodiscard]] const RowPart& at(std::int64_t y, std::int64_t z) const { return m_parts[index(y, z)]; }
    /// Adds to the part of a row. Several threads may mark different rows.
    void mark(std::int64_t y, std::int64_t z, const RowPart& part) {
        m_parts[index(y, z)] = m_parts[index(y, z)].joined(part);
    }
    [[nodiscard]] bool any() const { return partWithin({0, m_rows}, {0, m_slices}).any(); }
    /// The smallest part that holds the parts of all rows with y in `rows` and z in `slices`. The second number of a
    /// range is the first beyond the range. Rows beyond the grid have no part.
    using Range = std::array<std::int64_t, 2>;
    [[nodiscard]] RowPart partWithin(const Range& rows, const Range& slices) const;
    /// The parts, widened by this many voxels to both sides along x, y and z, within the grid.
    [[nodiscard]] RowMarks widened(const std::array<std::int64_t, 3>& voxels) const;
    /// Adds the parts of `other`, which is of the same grid.
    void add(const RowMarks& other);

private:
    [[nodiscard]] std::size_t index(std::int64_t y, std::int64_t z) const {
        return static_cast<std::size_t>(y + m_rows * z);
    }

    std::int32_t m_columns;
    std::int64_t m_rows, m_slices;
    std::vector<RowPart> m_parts;
};

/// The parts of rows in which two volumes of one grid mark different voxels as data (Volume::dataMask()). Takes one
/// pass over both masks, or none if they share one.
[[nodiscard]] RowMarks rowsMaskedOtherwise(const Volume& before, const Volume& after);

}  // namespace echolucent
