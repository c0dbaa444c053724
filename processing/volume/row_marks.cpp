#include "processing/volume/row_marks.h"

#include <algorithm>
#include <cstring>

#include "processing/parallel.h"

namespace echolucent {

bool RowMarks::anyWithin(const Range& along, const Range& slices) const {
    const std::int64_t first = std::max<std::int64_t>(along[0], 0), end = std::min(along[1], m_rows);
    if (first >= end) return false;
    for (std::int64_t z = std::max<std::int64_t>(slices[0], 0); z < std::min(slices[1], m_slices); ++z)
        if (std::memchr(m_marks.data() + index(first, z), 1, static_cast<std::size_t>(end - first)) != nullptr)
            return true;
    return false;
}

RowMarks RowMarks::widened(std::int64_t rows, std::int64_t slices) const {
    RowMarks wider = *this;
    for (std::int64_t z = 0; z < m_slices; ++z)
        for (std::int64_t y = 0; y < m_rows; ++y) {
            if (!at(y, z)) continue;
            const std::int64_t first = std::max<std::int64_t>(y - rows, 0), end = std::min(y + rows + 1, m_rows);
            for (std::int64_t slice = std::max<std::int64_t>(z - slices, 0); slice < std::min(z + slices + 1, m_slices);
                 ++slice)
                std::memset(wider.m_marks.data() + wider.index(first, slice), 1, static_cast<std::size_t>(end - first));
        }
    return wider;
}

void RowMarks::add(const RowMarks& other) {
    for (std::size_t i = 0; i < m_marks.size(); ++i) m_marks[i] |= other.m_marks[i];
}

RowMarks rowsMaskedOtherwise(const Volume& before, const Volume& after) {
    const VolumeGeometry& geometry = after.geometry();
    RowMarks rows(geometry.size);
    const std::uint8_t *left = before.dataMaskOrNull(), *right = after.dataMaskOrNull();
    if (left == right) return rows;
    const auto columns = static_cast<std::size_t>(geometry.size[0]);
    parallelFor(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
            const std::int64_t first = geometry.offset(0, y, z);
            // Where there is no mask, all voxels are data.
            const bool same = left == nullptr    ? std::memchr(right + first, 0, columns) == nullptr
                              : right == nullptr ? std::memchr(left + first, 0, columns) == nullptr
                                                 : std::memcmp(left + first, right + first, columns) == 0;
            if (!same) rows.mark(y, z);
        }
    });
    return rows;
}

}  // namespace echolucent
