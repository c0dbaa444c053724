// Which rows of a volume are meant, such as those that a stroke of the scalpel changed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// A set of a grid's rows along x.
class RowMarks {
public:
    explicit RowMarks(const std::array<std::int64_t, 3>& size, bool all = false)
        : m_rows(size[1]), m_slices(size[2]), m_marks(static_cast<std::size_t>(m_rows * m_slices), all ? 1 : 0) {}

    [[nodiscard]] std::int64_t rows() const { return m_rows; }      ///< in a slice, along y
    [[nodiscard]] std::int64_t slices() const { return m_slices; }  ///< along z
    [[nodiscard]] bool at(std::int64_t y, std::int64_t z) const { return m_marks[index(y, z)] != 0; }
    /// Different rows may be marked side by side.
    void mark(std::int64_t y, std::int64_t z) { m_marks[index(y, z)] = 1; }
    [[nodiscard]] bool any() const { return anyWithin({0, m_rows}, {0, m_slices}); }
    /// Whether a row of [first, second) along y and along z is marked; rows beyond the grid are not.
    using Range = std::array<std::int64_t, 2>;
    [[nodiscard]] bool anyWithin(const Range& along, const Range& slices) const;
    /// The rows, and those up to so many rows and slices beside them.
    [[nodiscard]] RowMarks widened(std::int64_t rows, std::int64_t slices) const;
    /// Adds the rows of another set of the same grid.
    void add(const RowMarks& other);

private:
    [[nodiscard]] std::size_t index(std::int64_t y, std::int64_t z) const {
        return static_cast<std::size_t>(y + m_rows * z);
    }

    std::int64_t m_rows, m_slices;
    std::vector<std::uint8_t> m_marks;
};

/// The rows in which two volumes of one grid mark other voxels as data (Volume::dataMask()). One pass over both masks,
/// none where they are the same.
[[nodiscard]] RowMarks rowsMaskedOtherwise(const Volume& before, const Volume& after);

}  // namespace echolucent
