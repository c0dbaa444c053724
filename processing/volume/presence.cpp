#include "processing/volume/presence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::uint8_t fullPresence = 255;
/// Rows or slices that are smoothed into one.
constexpr std::size_t taps = 2 * presenceReach + 1;
using Rows = std::array<const std::uint8_t*, taps>;

/// [1 4 6 4 1] / 16 of five rows of bytes.
void smoothRows(const Rows& from, std::int64_t count, std::uint8_t* __restrict to) {
    const std::uint8_t *a = from[0], *b = from[1], *c = from[2], *d = from[3], *e = from[4];
    // 16 bits are enough for the sums, and a vector holds twice as many numbers of 16 bits as ints.
    const auto wide = [](std::uint8_t byte) { return static_cast<std::uint16_t>(byte); };
    for (std::int64_t i = 0; i < count; ++i) {
        const auto outer = static_cast<std::uint16_t>(wide(a[i]) + wide(e[i]));
        const auto inner = static_cast<std::uint16_t>(wide(b[i]) + wide(d[i]) + wide(c[i]));
        const auto sum = static_cast<std::uint16_t>(outer + 4 * inner + 2 * wide(c[i]) + 8);
        to[i] = static_cast<std::uint8_t>(sum >> 4);
    }
}

/// The smoothed presence of a voxel, drawn back to what the mask says of the voxel (`data`). The agreement is the share
/// of the smoothed surroundings that the mask marks alike. Up to an agreement of 0.30 the mask alone counts, from 0.45
/// on the smoothed presence alone.
std::uint8_t keptThin(std::uint8_t smooth, bool data) {
    constexpr int thin = 77, wide = 115;  // bytes of agreement: 0.30, 0.45
    const int agreement = data ? smooth : fullPresence - smooth, said = data ? fullPresence : 0;
    const int share = std::clamp(wide - agreement, 0, wide - thin);
    return static_cast<std::uint8_t>(smooth + (said - smooth) * share / (wide - thin));
}

/// keptThin() of every byte: first for no data, then for data.
using KeptThin = std::array<std::array<std::uint8_t, 256>, 2>;
KeptThin keptThinTable() {
    KeptThin table{};
    for (std::size_t smooth = 0; smooth < 256; ++smooth)
        for (const bool isData : {false, true})
            table[isData ? 1 : 0][smooth] = keptThin(static_cast<std::uint8_t>(smooth), isData);
    return table;
}

/// The data of a row: 255 for a voxel with data, else 0.
template <typename Voxel>
class DataRows {
public:
    DataRows(const Volume& volume, const VoxelArray<Voxel>& voxels)
        : m_geometry(volume.geometry()), m_mask(volume.dataMaskOrNull()), m_voxels(voxels) {}

    /// Writes `part` of the row (y, z). `to` begins with the first voxel of the part.
    void write(std::int64_t y, std::int64_t z, const RowPart& part, std::uint8_t* __restrict to) const {
        const std::int64_t first = m_geometry.offset(part.first, y, z), count = part.count();
        if (m_mask == nullptr) std::fill_n(to, count, fullPresence);
        const std::uint8_t* marks = m_mask == nullptr ? nullptr : m_mask + first;
        for (std::int64_t x = 0; x < count && marks != nullptr; ++x) to[x] = marks[x] != 0 ? fullPresence : 0;
        if constexpr (std::is_same_v<Voxel, float>)
            for (std::int64_t x = 0; x < count; ++x)
                if (!std::isfinite(m_voxels[static_cast<std::size_t>(first + x)])) to[x] = 0;
    }

private:
    const VolumeGeometry& m_geometry;
    const std::uint8_t* m_mask;
    const VoxelArray<Voxel>& m_voxels;
};

/// Smooths slices one after another. It keeps the smoothed slices around the newest one.
template <typename Voxel>
class SliceSmoother {
public:
    SliceSmoother(const Volume& volume, const VoxelArray<Voxel>& voxels, const RowMarks& rows, const KeptThin& kept)
        : m_data(volume, voxels),
          m_rows(rows),
          m_kept(kept),
          m_columns(volume.geometry().size[0]),
          m_asked(askedAt(rows.rows()) + static_cast<std::size_t>(presenceReach)),
          m_room(static_cast<std::size_t>(m_columns + 2 * presenceReach)),
          m_marks(static_cast<std::size_t>(m_columns)),
          m_alongX(static_cast<std::size_t>(m_columns * rows.rows())),
          m_presence(m_alongX.size()) {
        for (auto& slice : m_smooth) slice.resize(m_alongX.size());
    }

    /// The presence in slice `z`, filled only in the parts of rows that are marked. Valid until the next call. Ask for
    /// slices in ascending order.
    const std::uint8_t* at(std::int64_t z) {
        for (m_next = std::max(m_next, z - presenceReach); m_next <= z + presenceReach; ++m_next)
            if (m_next >= 0 && m_next < m_rows.slices()) smoothWithin(m_next);
        for (std::int64_t y = 0; y < m_rows.rows(); ++y)
            if (m_rows.at(y, z).any()) smoothAcross(y, z);
        return m_presence.data();
    }

private:
    /// Smooths slice `z` along x and y, only in the parts of rows that this slice or a slice within presenceReach
    /// marks.
    void smoothWithin(std::int64_t z) {
        std::ranges::fill(m_asked, RowPart{});
        for (std::int64_t slice = std::max<std::int64_t>(z - presenceReach, 0);
             slice < std::min(z + presenceReach + 1, m_rows.slices()); ++slice)
            for (std::int64_t y = 0; y < m_rows.rows(); ++y)
                m_asked[askedAt(y)] = m_asked[askedAt(y)].joined(m_rows.at(y, slice));
        for (std::int64_t y = 0; y < m_rows.rows(); ++y) {
            RowPart part;
            for (std::size_t i = 0; i < taps; ++i) part = part.joined(m_asked[askedAt(y - presenceReach) + i]);
            if (part.any()) smoothAlong(y, z, part);
        }
        std::vector<std::uint8_t>& slice = m_smooth[static_cast<std::size_t>(z) % taps];
        for (std::int64_t y = 0; y < m_rows.rows(); ++y) {
            const RowPart& part = m_asked[askedAt(y)];
            if (!part.any()) continue;
            smoothRows(around(y, m_rows.rows(), [&](std::int64_t row) { return &m_alongX[place(row, part)]; }),
                       part.count(), &slice[place(y, part)]);
        }
    }

    /// Smooths a part of the row (y, z) along x. Beyond a row's ends, the end voxels are repeated.
    void smoothAlong(std::int64_t y, std::int64_t z, const RowPart& part) {
        constexpr auto reach = static_cast<std::int32_t>(presenceReach);
        const auto columns = static_cast<std::int32_t>(m_columns);
        const RowPart read{std::max(part.first - reach, 0), std::min(part.last + reach, columns)};
        std::uint8_t* row = m_room.data() + reach;
        m_data.write(y, z, read, row + read.first);
        if (read.first == 0) std::fill_n(row - reach, reach, row[0]);
        if (read.last == columns) std::fill_n(row + columns, reach, row[columns - 1]);
        const std::uint8_t* from = row + part.first;
        smoothRows({from - 2, from - 1, from, from + 1, from + 2}, part.count(), &m_alongX[place(y, part)]);
    }

    void smoothAcross(std::int64_t y, std::int64_t z) {
        const RowPart& part = m_rows.at(y, z);
        const std::int64_t count = part.count();
        std::uint8_t* smooth = &m_presence[place(y, part)];
        smoothRows(around(z, m_rows.slices(),
                          [&](std::int64_t slice) {
                              return m_smooth[static_cast<std::size_t>(slice) % taps].data() + place(y, part);
                          }),
                   count, smooth);
        m_data.write(y, z, part, m_marks.data());
        // Most blocks lie deep in data or far from it, where smoothing changes nothing.
        constexpr std::int64_t block = 64;
        for (std::int64_t x = 0; x < count; x += block) {
            const std::int64_t end = std::min(x + block, count);
            std::uint8_t apart = 0;
            for (std::int64_t i = x; i < end; ++i) apart |= static_cast<std::uint8_t>(smooth[i] ^ m_marks[i]);
            for (std::int64_t i = x; i < end && apart != 0; ++i) smooth[i] = m_kept[m_marks[i] != 0 ? 1 : 0][smooth[i]];
        }
    }

    /// The rows or slices around one. Beyond the grid, the outermost one is repeated.
    template <typename RowOf>
    static Rows around(std::int64_t middle, std::int64_t count, const RowOf& rowOf) {
        Rows rows{};
        for (std::size_t i = 0; i < taps; ++i)
            rows[i] =
                rowOf(std::clamp<std::int64_t>(middle + static_cast<std::int64_t>(i) - presenceReach, 0, count - 1));
        return rows;
    }
    [[nodiscard]] static std::size_t askedAt(std::int64_t y) { return static_cast<std::size_t>(y + presenceReach); }
    [[nodiscard]] std::size_t place(std::int64_t y, const RowPart& part) const {
        return static_cast<std::size_t>(y * m_columns + part.first);
    }

    DataRows<Voxel> m_data;
    const RowMarks& m_rows;
    const KeptThin& m_kept;
    std::int64_t m_columns, m_next = 0;  ///< m_next: the slice that is smoothed next
    std::vector<RowPart> m_asked;        ///< for each row, with presenceReach rows more at both ends
    std::vector<std::uint8_t> m_room, m_marks, m_alongX, m_presence;
    std::array<std::vector<std::uint8_t>, taps> m_smooth;  ///< the newest slices along x and y; slice z at z % taps
};

}  // namespace

bool lacksData(const Volume& volume) {
    const DataMask& mask = volume.dataMask();
    if (std::ranges::find(mask, std::uint8_t{0}) != mask.end()) return true;
    const auto* floats = std::get_if<VoxelArray<float>>(&volume.voxels());
    return floats != nullptr && !std::ranges::all_of(*floats, [](float value) { return std::isfinite(value); });
}

void makePresence(const Volume& volume, const RowMarks& rows, const TakePresence& take) {
    const KeptThin kept = keptThinTable();
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            // Each part also smooths the slices beside it. In smaller parts, more slices would be smoothed twice.
            constexpr std::int64_t part = 16;
            parallelFor(LoopRange<std::int64_t>(0, rows.slices(), part), [&](const auto& slices) {
                if (!rows.partWithin({0, rows.rows()}, {slices.begin(), slices.end()}).any()) return;
                SliceSmoother<Voxel> smoother(volume, voxels, rows, kept);
                for (std::int64_t z = slices.begin(); z < slices.end(); ++z)
                    if (rows.partWithin({0, rows.rows()}, {z, z + 1}).any()) take(z, smoother.at(z));
            });
        },
        volume.voxels());
}

}  // namespace echolucent
