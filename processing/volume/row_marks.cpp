#include "processing/volume/row_marks.h"

#include <cstring>

#include "processing/parallel.h"

namespace echolucent {

RowPart RowMarks::partWithin(const Range& rows, const Range& slices) const {
    RowPart part;
    for (std::int64_t z = std::max<std::int64_t>(slices[0], 0); z < std::min(slices[1], m_slices); ++z)
        for (std::int64_t y = std::max<std::int64_t>(rows[0], 0); y < std::min(rows[1], m_rows); ++y)
            part = part.joined(at(y, z));
    return part;
}

RowMarks RowMarks::widened(const std::array<std::int64_t, 3>& voxels) const {
    // Each axis is widened by itself, so that a mark becomes a box.
    RowMarks inSlices = *this, wider = *this;
    const auto beside = static_cast<std::int32_t>(voxels[0]);
    for (std::int64_t z = 0; z < m_slices; ++z)
        for (std::int64_t y = 0; y < m_rows; ++y) {
            RowPart part = partWithin({y - voxels[1], y + voxels[1] + 1}, {z, z + 1});
            if (part.any()) part = {std::max(part.first - beside, 0), std::min(part.last + beside, m_columns)};
            inSlices.m_parts[index(y, z)] = part;
        }
    for (std::int64_t z = 0; z < m_slices; ++z)
        for (std::int64_t y = 0; y < m_rows; ++y)
            wider.m_parts[index(y, z)] = inSlices.partWithin({y, y + 1}, {z - voxels[2], z + voxels[2] + 1});
    return wider;
}

void RowMarks::add(const RowMarks& other) {
    for (std::size_t i = 0; i < m_parts.size(); ++i) m_parts[i] = m_parts[i].joined(other.m_parts[i]);
}

namespace {

/// The smallest part that holds all differences of two rows.
RowPart differing(const std::uint8_t* a, const std::uint8_t* b, std::int64_t count) {
    if (std::memcmp(a, b, static_cast<std::size_t>(count)) == 0) return {};
    constexpr std::int64_t word = 8;
    const auto same = [&](std::int64_t at) { return std::memcmp(a + at, b + at, word) == 0; };
    std::int64_t first = 0, last = count;
    while (first + word <= count && same(first)) first += word;
    while (a[first] == b[first]) ++first;
    while (last - word >= first && same(last - word)) last -= word;
    while (a[last - 1] == b[last - 1]) --last;
    return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
}

}  // namespace

RowMarks rowsMaskedOtherwise(const Volume& before, const Volume& after) {
    const VolumeGeometry& geometry = after.geometry();
    RowMarks rows(geometry.size);
    const std::uint8_t *left = before.dataMaskOrNull(), *right = after.dataMaskOrNull();
    if (left == right) return rows;
    // Without a mask, all voxels are data.
    const std::vector<std::uint8_t> allData(static_cast<std::size_t>(geometry.size[0]), 1);
    parallelFor(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
            const auto rowOf = [&](const std::uint8_t* mask) {
                return mask == nullptr ? allData.data() : mask + geometry.offset(0, y, z);
            };
            rows.mark(y, z, differing(rowOf(left), rowOf(right), geometry.size[0]));
        }
    });
    return rows;
}

}  // namespace echolucent
