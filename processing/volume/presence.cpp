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

/// A kernel that smooths the mask along an axis. Rows or slices `from`, as many as it has taps, are smoothed into one.
/// The narrow one says what lies within two voxels: [1 4 6 4 1] / 16.
struct NarrowKernel {
    using Sample = std::uint8_t;
    static constexpr std::int64_t reach = 2;
    static constexpr Sample full = fullPresence;  ///< of a voxel with data
    using Rows = std::array<const Sample*, 2 * reach + 1>;

    static void smooth(const Rows& from, std::int64_t count, Sample* __restrict to) {
        const Sample *a = from[0], *b = from[1], *c = from[2], *d = from[3], *e = from[4];
        // 16 bits are enough for the sums, and a vector holds twice as many numbers of 16 bits as ints.
        const auto wide = [](Sample byte) { return static_cast<std::uint16_t>(byte); };
        for (std::int64_t i = 0; i < count; ++i) {
            const auto outer = static_cast<std::uint16_t>(wide(a[i]) + wide(e[i]));
            const auto inner = static_cast<std::uint16_t>(wide(b[i]) + wide(d[i]) + wide(c[i]));
            const auto sum = static_cast<std::uint16_t>(outer + 4 * inner + 2 * wide(c[i]) + 8);
            to[i] = static_cast<Sample>(sum >> 4);
        }
    }
};

/// The wide one averages stairs of up to a dozen voxels: [1 3 6 10 15 19 20 19 15 10 6 3 1] / 128, almost a Gaussian of
/// 2.4 voxels (docs/rendering.md).
struct WideKernel {
    using Sample = std::uint16_t;
    static constexpr std::int64_t reach = 6;
    static constexpr Sample full = 2 * fullPresence;  ///< the largest whose weighted sums fit into 16 bits
    using Rows = std::array<const Sample*, 2 * reach + 1>;
    /// Share of the weights up to a border, for borders 1/2, 3/2, 5/2 ... voxels before a voxel's centre, of 128.
    static constexpr std::array<int, 7> upTo{74, 93, 108, 118, 124, 127, 128};

    static void smooth(const Rows& from, std::int64_t count, Sample* __restrict to) {
        const auto add = [](unsigned a, unsigned b) { return static_cast<std::uint16_t>(a + b); };
        for (std::int64_t i = 0; i < count; ++i) {
            std::uint16_t sum = add(from[0][i], from[12][i]);
            sum = add(sum, 3U * add(from[1][i], from[11][i]));
            sum = add(sum, 6U * add(from[2][i], from[10][i]));
            sum = add(sum, 10U * add(from[3][i], from[9][i]));
            sum = add(sum, 15U * add(from[4][i], from[8][i]));
            sum = add(sum, 19U * add(from[5][i], from[7][i]));
            sum = add(sum, 20U * from[6][i] + 64U);
            to[i] = static_cast<Sample>(sum >> 7);
        }
    }
};
static_assert(WideKernel::reach == presenceReach);

/// The narrow presence of a voxel, drawn back to what the mask says of the voxel (`data`). The agreement is the share
/// of the smoothed surroundings that the mask marks alike. Up to an agreement of 0.30 the mask alone counts, from 0.45
/// on the smoothed presence alone.
int keptThin(int narrow, bool data) {
    constexpr int thin = 77, wide = 115;  // bytes of agreement: 0.30, 0.45
    const int agreement = data ? narrow : fullPresence - narrow, said = data ? fullPresence : 0;
    const int share = std::clamp(wide - agreement, 0, wide - thin);
    return narrow + (said - narrow) * share / (wide - thin);
}

/// The narrow presence at a plane, by the wide one there: the same distance from the plane says both. Linear between
/// the voxels of a plane across an axis.
int narrowOfWide(int wide) {
    constexpr std::array<int, 7> narrow{11 * 16, 15 * 16, 256, 256, 256, 256, 256};  // of 256
    const double share = 128.0 * std::abs(wide - fullPresence) / WideKernel::full + 64.0;
    std::size_t i = 0;
    while (i + 1 < narrow.size() && share > WideKernel::upTo[i]) ++i;
    const double from = i == 0 ? 64.0 : WideKernel::upTo[i - 1], low = i == 0 ? 128.0 : narrow[i - 1];
    const double above = low + (share - from) / (WideKernel::upTo[i] - from) * (narrow[i] - low);
    return static_cast<int>(std::lround((wide < fullPresence ? 256.0 - above : above) * fullPresence / 256.0));
}

/// Both presences of a voxel as one. Near a smooth border they differ by the stairs, which the wide one has not: up to
/// 0.2. At corners and structures a few voxels thick, which the wide one does not see, they differ more: from 0.4 on
/// the narrow one alone counts.
class Joined {
public:
    Joined() {
        for (std::size_t narrow = 0; narrow < 256; ++narrow)
            for (const bool data : {false, true})
                m_narrow[data ? 1 : 0][narrow] = static_cast<std::uint8_t>(keptThin(static_cast<int>(narrow), data));
        for (std::size_t wide = 0; wide < m_wide.size(); ++wide)
            m_wide[wide] = static_cast<std::uint8_t>(narrowOfWide(static_cast<int>(wide)));
    }
    [[nodiscard]] std::uint8_t at(std::uint8_t narrow, std::uint16_t wide, bool data) const {
        constexpr int same = 51, other = 102;  // bytes of difference: 0.2, 0.4
        const int kept = m_narrow[data ? 1 : 0][narrow], apart = m_wide[wide] - kept;
        const int share = std::clamp(other - std::abs(apart), 0, other - same);
        return static_cast<std::uint8_t>(kept + apart * share / (other - same));
    }

private:
    std::array<std::array<std::uint8_t, 256>, 2> m_narrow{};  ///< keptThin() without data, with data
    std::array<std::uint8_t, WideKernel::full + 1> m_wide{};  ///< narrowOfWide()
};

/// The data of a row: Kernel::full for a voxel with data, else 0.
template <typename Voxel>
class DataRows {
public:
    DataRows(const Volume& volume, const VoxelArray<Voxel>& voxels)
        : m_geometry(volume.geometry()), m_mask(volume.dataMaskOrNull()), m_voxels(voxels) {}

    /// Writes `part` of the row (y, z). `to` begins with the first voxel of the part.
    template <typename Sample>
    void write(std::int64_t y, std::int64_t z, const RowPart& part, Sample full, Sample* __restrict to) const {
        const std::int64_t first = m_geometry.offset(part.first, y, z), count = part.count();
        if (m_mask == nullptr) std::fill_n(to, count, full);
        const std::uint8_t* marks = m_mask == nullptr ? nullptr : m_mask + first;
        for (std::int64_t x = 0; x < count && marks != nullptr; ++x) to[x] = marks[x] != 0 ? full : Sample{0};
        if constexpr (std::is_same_v<Voxel, float>)
            for (std::int64_t x = 0; x < count; ++x)
                if (!std::isfinite(m_voxels[static_cast<std::size_t>(first + x)])) to[x] = 0;
    }

private:
    const VolumeGeometry& m_geometry;
    const std::uint8_t* m_mask;
    const VoxelArray<Voxel>& m_voxels;
};

/// Smooths slices one after another by a kernel. It keeps the smoothed slices around the newest one.
template <typename Kernel, typename Voxel>
class SliceSmoother {
public:
    using Sample = typename Kernel::Sample;

    SliceSmoother(const DataRows<Voxel>& data, const RowMarks& rows, std::int64_t columns)
        : m_data(data),
          m_rows(rows),
          m_columns(columns),
          m_asked(askedAt(rows.rows()) + static_cast<std::size_t>(Kernel::reach)),
          m_room(static_cast<std::size_t>(m_columns + 2 * Kernel::reach)),
          m_alongX(static_cast<std::size_t>(m_columns * rows.rows())),
          m_presence(static_cast<std::size_t>(m_columns)) {
        for (auto& slice : m_smooth) slice.resize(m_alongX.size());
    }

    /// Goes on to slice `z`. Slices come in ascending order.
    void goTo(std::int64_t z) {
        for (m_next = std::max(m_next, z - Kernel::reach); m_next <= z + Kernel::reach; ++m_next)
            if (m_next >= 0 && m_next < m_rows.slices()) smoothWithin(m_next);
        m_slice = z;
    }
    /// The marked part of row `y` of the slice, valid until the next call.
    const Sample* row(std::int64_t y) {
        const RowPart& part = m_rows.at(y, m_slice);
        Kernel::smooth(around(m_slice, m_rows.slices(),
                              [&](std::int64_t slice) {
                                  return m_smooth[static_cast<std::size_t>(slice) % taps].data() + place(y, part);
                              }),
                       part.count(), m_presence.data());
        return m_presence.data();
    }

private:
    static constexpr std::size_t taps = 2 * Kernel::reach + 1;
    using Rows = typename Kernel::Rows;

    /// Smooths slice `z` along x and y, only in the parts of rows that this slice or a slice within reach marks.
    void smoothWithin(std::int64_t z) {
        std::ranges::fill(m_asked, RowPart{});
        for (std::int64_t slice = std::max<std::int64_t>(z - Kernel::reach, 0);
             slice < std::min(z + Kernel::reach + 1, m_rows.slices()); ++slice)
            for (std::int64_t y = 0; y < m_rows.rows(); ++y)
                m_asked[askedAt(y)] = m_asked[askedAt(y)].joined(m_rows.at(y, slice));
        for (std::int64_t y = 0; y < m_rows.rows(); ++y) {
            RowPart part;
            for (std::size_t i = 0; i < taps; ++i) part = part.joined(m_asked[askedAt(y - Kernel::reach) + i]);
            if (part.any()) smoothAlong(y, z, part);
        }
        std::vector<Sample>& slice = m_smooth[static_cast<std::size_t>(z) % taps];
        for (std::int64_t y = 0; y < m_rows.rows(); ++y) {
            const RowPart& part = m_asked[askedAt(y)];
            if (!part.any()) continue;
            Kernel::smooth(around(y, m_rows.rows(), [&](std::int64_t row) { return &m_alongX[place(row, part)]; }),
                           part.count(), &slice[place(y, part)]);
        }
    }

    /// Smooths a part of the row (y, z) along x. Beyond a row's ends, the end voxels are repeated.
    void smoothAlong(std::int64_t y, std::int64_t z, const RowPart& part) {
        constexpr auto reach = static_cast<std::int32_t>(Kernel::reach);
        const auto columns = static_cast<std::int32_t>(m_columns);
        const RowPart read{std::max(part.first - reach, 0), std::min(part.last + reach, columns)};
        Sample* row = m_room.data() + reach;
        m_data.write(y, z, read, Kernel::full, row + read.first);
        if (read.first == 0) std::fill_n(row - reach, reach, row[0]);
        if (read.last == columns) std::fill_n(row + columns, reach, row[columns - 1]);
        Rows from{};
        for (std::size_t i = 0; i < taps; ++i) from[i] = row + part.first - reach + static_cast<std::int64_t>(i);
        Kernel::smooth(from, part.count(), &m_alongX[place(y, part)]);
    }

    /// The rows or slices around one. Beyond the grid, the outermost one is repeated.
    template <typename RowOf>
    static Rows around(std::int64_t middle, std::int64_t count, const RowOf& rowOf) {
        Rows rows{};
        for (std::size_t i = 0; i < taps; ++i)
            rows[i] =
                rowOf(std::clamp<std::int64_t>(middle + static_cast<std::int64_t>(i) - Kernel::reach, 0, count - 1));
        return rows;
    }
    [[nodiscard]] static std::size_t askedAt(std::int64_t y) { return static_cast<std::size_t>(y + Kernel::reach); }
    [[nodiscard]] std::size_t place(std::int64_t y, const RowPart& part) const {
        return static_cast<std::size_t>(y * m_columns + part.first);
    }

    const DataRows<Voxel>& m_data;
    const RowMarks& m_rows;
    std::int64_t m_columns, m_next = 0, m_slice = 0;  ///< m_next: the slice that is smoothed next
    std::vector<RowPart> m_asked;                     ///< for each row, with the kernel's reach more at both ends
    std::vector<Sample> m_room, m_alongX, m_presence;
    std::array<std::vector<Sample>, taps> m_smooth;  ///< the newest slices along x and y; slice z at z % taps
};

/// The presence in slices, one after another.
template <typename Voxel>
class PresenceSlices {
public:
    PresenceSlices(const Volume& volume, const VoxelArray<Voxel>& voxels, const RowMarks& rows, const Joined& joined)
        : m_data(volume, voxels),
          m_rows(rows),
          m_joined(joined),
          m_columns(volume.geometry().size[0]),
          m_narrow(m_data, rows, m_columns),
          m_wide(m_data, rows, m_columns),
          m_marks(static_cast<std::size_t>(m_columns)),
          m_presence(static_cast<std::size_t>(m_columns * rows.rows())) {}

    /// The presence in slice `z`, filled only in the parts of rows that are marked. Valid until the next call. Ask for
    /// slices in ascending order.
    const std::uint8_t* at(std::int64_t z) {
        m_narrow.goTo(z);
        m_wide.goTo(z);
        for (std::int64_t y = 0; y < m_rows.rows(); ++y)
            if (m_rows.at(y, z).any()) join(y, z);
        return m_presence.data();
    }

private:
    void join(std::int64_t y, std::int64_t z) {
        const RowPart& part = m_rows.at(y, z);
        const std::int64_t count = part.count();
        std::uint8_t* to = m_presence.data() + y * m_columns + part.first;
        const std::uint8_t* narrow = m_narrow.row(y);
        const std::uint16_t* wide = m_wide.row(y);
        m_data.write(y, z, part, fullPresence, m_marks.data());
        // Most blocks lie deep in data or far from it, where smoothing changes nothing.
        constexpr std::int64_t block = 64;
        for (std::int64_t x = 0; x < count; x += block) {
            const std::int64_t end = std::min(x + block, count);
            std::uint16_t apart = 0;
            for (std::int64_t i = x; i < end; ++i) apart |= static_cast<std::uint16_t>(wide[i] ^ (2U * m_marks[i]));
            if (apart == 0)
                std::copy(m_marks.begin() + x, m_marks.begin() + end, to + x);
            else
                for (std::int64_t i = x; i < end; ++i) to[i] = m_joined.at(narrow[i], wide[i], m_marks[i] != 0);
        }
    }

    DataRows<Voxel> m_data;
    const RowMarks& m_rows;
    const Joined& m_joined;
    std::int64_t m_columns;
    SliceSmoother<NarrowKernel, Voxel> m_narrow;
    SliceSmoother<WideKernel, Voxel> m_wide;
    std::vector<std::uint8_t> m_marks, m_presence;
};

}  // namespace

bool lacksData(const Volume& volume) {
    const DataMask& mask = volume.dataMask();
    if (std::ranges::find(mask, std::uint8_t{0}) != mask.end()) return true;
    const auto* floats = std::get_if<VoxelArray<float>>(&volume.voxels());
    return floats != nullptr && !std::ranges::all_of(*floats, [](float value) { return std::isfinite(value); });
}

void makePresence(const Volume& volume, const RowMarks& rows, const TakePresence& take) {
    const Joined joined;
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            // Each part also smooths the slices beside it. In smaller parts, more slices would be smoothed twice.
            constexpr std::int64_t part = 16;
            parallelFor(LoopRange<std::int64_t>(0, rows.slices(), part), [&](const auto& slices) {
                if (!rows.partWithin({0, rows.rows()}, {slices.begin(), slices.end()}).any()) return;
                PresenceSlices<Voxel> presence(volume, voxels, rows, joined);
                for (std::int64_t z = slices.begin(); z < slices.end(); ++z)
                    if (rows.partWithin({0, rows.rows()}, {z, z + 1}).any()) take(z, presence.at(z));
            });
        },
        volume.voxels());
}

}  // namespace echolucent
