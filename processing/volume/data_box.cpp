// The box around the voxels that carry data.

#include <algorithm>
#include <array>
#include <vector>

#include "processing/parallel.h"
#include "processing/volume/volume.h"

namespace echolucent {

namespace {

/// The first and the last index with data along each axis; last < first if there is none.
struct IndexRange {
    std::array<std::int64_t, 3> first, last;

    explicit IndexRange(const std::array<std::int64_t, 3>& size) : first(size), last{-1, -1, -1} {}
    void add(std::size_t axis, std::int64_t index) {
        first[axis] = std::min(first[axis], index);
        last[axis] = std::max(last[axis], index);
    }
    void join(const IndexRange& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first[axis] = std::min(first[axis], other.first[axis]);
            last[axis] = std::max(last[axis], other.last[axis]);
        }
    }
};

/// Adds to `range` where a row's data begin and end, without reading between.
void addRow(std::span<const std::uint8_t> row, std::int64_t y, std::int64_t z, IndexRange& range) {
    const auto isData = [](std::uint8_t mark) { return mark != 0; };
    const auto first = std::find_if(row.begin(), row.end(), isData);
    if (first == row.end()) return;
    const auto last = std::find_if(row.rbegin(), row.rend(), isData);
    range.add(0, first - row.begin());
    range.add(0, row.rend() - last - 1);
    range.add(1, y);
    range.add(2, z);
}

IndexRange rangeOf(const VolumeGeometry& geometry, std::span<const std::uint8_t> mask) {
    const auto& size = geometry.size;
    std::vector<IndexRange> slices(static_cast<std::size_t>(size[2]), IndexRange(size));
    parallelFor(std::int64_t{0}, size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < size[1]; ++y)
            addRow(mask.subspan(static_cast<std::size_t>(geometry.offset(0, y, z)), static_cast<std::size_t>(size[0])),
                   y, z, slices[static_cast<std::size_t>(z)]);
    });
    IndexRange range(size);
    for (const IndexRange& slice : slices) range.join(slice);
    return range;
}

}  // namespace

DataBox::DataBox(const VolumeGeometry& geometry) : lowMm(geometry.boxMinMm()), highMm(geometry.boxMaxMm()) {}

DataBox DataBox::joined(const DataBox& other) const {
    DataBox both = *this;
    for (int axis = 0; axis < 3; ++axis) {
        both.lowMm[axis] = std::min(lowMm[axis], other.lowMm[axis]);
        both.highMm[axis] = std::max(highMm[axis], other.highMm[axis]);
    }
    return both;
}

DataBox dataBoxOf(const VolumeGeometry& geometry, std::span<const std::uint8_t> mask) {
    if (mask.empty()) return geometry;
    const IndexRange range = rangeOf(geometry, mask);
    if (range.last[0] < 0) return geometry;
    DataBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        box.lowMm[axis] = (static_cast<double>(range.first[i]) - 0.5) * geometry.spacing[axis];
        box.highMm[axis] = (static_cast<double>(range.last[i]) + 0.5) * geometry.spacing[axis];
    }
    return box;
}

}  // namespace echolucent
