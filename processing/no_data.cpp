#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "processing/volume.h"

namespace echolucent {

namespace {

using Mask = std::vector<std::uint8_t>;

/// Least share of the grid that the outside of a sector takes; less is not worth a guess.
constexpr double smallestShare = 0.02;
/// Least share of the outside that lies two voxels or deeper inside it: a sector's outside is thick, speckle's zeros are not.
constexpr double smallestThickShare = 0.4;

class SectorGuess {
public:
    explicit SectorGuess(const Volume& volume) : m_size(volume.geometry().size) {
        const auto count = static_cast<std::size_t>(volume.geometry().voxelCount());
        m_zero.resize(count);
        std::visit(
            [&](const auto& values) {
                std::transform(values.begin(), values.end(), m_zero.begin(),
                               [](auto value) { return static_cast<std::uint8_t>(value == 0 ? 1 : 0); });
            },
            volume.voxels());
        for (std::size_t i = 0; i < count && !volume.dataMask().empty(); ++i)
            if (volume.dataMask()[i] == 0) m_zero[i] = 1;
        m_outside.assign(count, 0);
    }

    /// Zeros connected to a corner of the grid: a sector always leaves corners free, a pool of fluid at the probe does not.
    void fillFromCorners() {
        for (int corner = 0; corner < 8; ++corner)
            fillFrom(corner & 1 ? m_size[0] - 1 : 0, corner & 2 ? m_size[1] - 1 : 0, corner & 4 ? m_size[2] - 1 : 0);
    }

    /// Single voxels with a value in the midst of the outside are noise of compression or of painting over.
    void takeInSpecks() {
        Mask grown = m_outside;
        forEachVoxel([&](std::int64_t x, std::int64_t y, std::int64_t z, std::size_t at) {
            if (m_outside[at] == 0 && neighboursOutside(x, y, z, 1) >= 5) grown[at] = 1;
        });
        m_outside = std::move(grown);
    }

    [[nodiscard]] bool isPlausible() const {
        std::size_t outside = 0, thick = 0;
        forEachVoxel([&](std::int64_t x, std::int64_t y, std::int64_t z, std::size_t at) {
            if (m_outside[at] == 0) return;
            ++outside;
            if (neighboursOutside(x, y, z, 2) == 6) ++thick;
        });
        const auto all = static_cast<double>(m_outside.size());
        const auto share = static_cast<double>(outside) / all;
        return share >= smallestShare && outside < m_outside.size() &&
               static_cast<double>(thick) >= smallestThickShare * static_cast<double>(outside);
    }

    /// 1 = data.
    [[nodiscard]] Mask dataMask(const Volume& volume) const {
        Mask mask(m_outside.size());
        for (std::size_t i = 0; i < mask.size(); ++i)
            mask[i] = m_outside[i] == 0 && volume.hasData(static_cast<std::int64_t>(i)) ? 1 : 0;
        return mask;
    }

private:
    using Point = std::array<std::int64_t, 3>;

    [[nodiscard]] std::size_t at(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return static_cast<std::size_t>(x + m_size[0] * (y + m_size[1] * z));
    }

    template <typename Visit>
    void forEachVoxel(Visit visit) const {
        std::size_t offset = 0;
        for (std::int64_t z = 0; z < m_size[2]; ++z)
            for (std::int64_t y = 0; y < m_size[1]; ++y)
                for (std::int64_t x = 0; x < m_size[0]; ++x) visit(x, y, z, offset++);
    }

    /// How many of the six neighbours at a distance lie outside the sector; beyond the grid counts as outside.
    [[nodiscard]] int neighboursOutside(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t distance) const {
        int count = 0;
        for (const std::int64_t step : {-distance, distance}) {
            count += x + step < 0 || x + step >= m_size[0] || m_outside[at(x + step, y, z)] != 0 ? 1 : 0;
            count += y + step < 0 || y + step >= m_size[1] || m_outside[at(x, y + step, z)] != 0 ? 1 : 0;
            count += z + step < 0 || z + step >= m_size[2] || m_outside[at(x, y, z + step)] != 0 ? 1 : 0;
        }
        return count;
    }

    /// Scanline flood fill with a stack of its own: whole runs along x, their neighbour rows looked at once each.
    void fillFrom(std::int64_t x, std::int64_t y, std::int64_t z) {
        std::vector<Point> seeds{{x, y, z}};
        while (!seeds.empty()) {
            const auto [sx, sy, sz] = seeds.back();
            seeds.pop_back();
            if (!isOpen(at(sx, sy, sz))) continue;
            std::int64_t first = sx, last = sx;
            while (first > 0 && isOpen(at(first - 1, sy, sz))) --first;
            while (last + 1 < m_size[0] && isOpen(at(last + 1, sy, sz))) ++last;
            const std::size_t row = at(0, sy, sz);
            std::fill(m_outside.begin() + static_cast<std::ptrdiff_t>(row) + first,
                      m_outside.begin() + static_cast<std::ptrdiff_t>(row) + last + 1, std::uint8_t{1});
            if (sy > 0) seedRuns(first, last, sy - 1, sz, seeds);
            if (sy + 1 < m_size[1]) seedRuns(first, last, sy + 1, sz, seeds);
            if (sz > 0) seedRuns(first, last, sy, sz - 1, seeds);
            if (sz + 1 < m_size[2]) seedRuns(first, last, sy, sz + 1, seeds);
        }
    }

    [[nodiscard]] bool isOpen(std::size_t offset) const { return m_zero[offset] != 0 && m_outside[offset] == 0; }

    void seedRuns(std::int64_t first, std::int64_t last, std::int64_t y, std::int64_t z, std::vector<Point>& seeds) const {
        const std::size_t row = at(0, y, z);
        bool inRun = false;
        for (std::int64_t x = first; x <= last; ++x) {
            const bool open = isOpen(row + static_cast<std::size_t>(x));
            if (open && !inRun) seeds.push_back({x, y, z});
            inRun = open;
        }
    }

    std::array<std::int64_t, 3> m_size;
    Mask m_zero;
    Mask m_outside;
};

}  // namespace

std::vector<std::uint8_t> guessDataMask(const Volume& volume) {
    SectorGuess guess(volume);
    guess.fillFromCorners();
    guess.takeInSpecks();
    return guess.isPlausible() ? guess.dataMask(volume) : volume.dataMask();
}

}  // namespace echolucent
