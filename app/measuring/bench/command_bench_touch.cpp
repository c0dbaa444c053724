#include <algorithm>
#include <cmath>
#include <set>

#include "app/measuring/bench/command_bench.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent::cli {

std::vector<TubeSamples> samplesOfTubes(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config) {
    const auto axes = tubeAxes(volume.geometry(), view, config.grid, config.cells.size);
    return samplesOf(axes, volume.geometry(), view, config.cells.size);
}

namespace {

/// Voxel offsets of the rows (along x) that hold a sample.
std::vector<std::size_t> rowsHolding(const std::vector<TubeSamples>& tubes, const VolumeGeometry& geometry) {
    std::set<std::size_t> rows;
    for (const TubeSamples& tube : tubes) {
        const double half = (tube.cellSize - 1) / 2.0;
        for (int k = 0; k < tube.slabs; ++k)
            for (int b = 0; b < tube.cellSize; ++b)
                for (int a = 0; a < tube.cellSize; ++a) {
                    const Vec3 voxel = tube.onAxis(k) + tube.down * (b - half) + tube.right * (a - half);
                    const std::int64_t y = std::llround(voxel[1]), z = std::llround(voxel[2]);
                    if (y >= 0 && y < geometry.size[1] && z >= 0 && z < geometry.size[2])
                        rows.insert(static_cast<std::size_t>(geometry.offset(0, y, z)));
                }
    }
    return {rows.begin(), rows.end()};
}

template <typename Voxel>
using Total = std::conditional_t<std::is_integral_v<Voxel>, std::uint32_t, float>;

template <typename Voxel>
double touchRows(const Voxel* voxels, const std::vector<std::size_t>& rows, std::size_t length) {
    double sum = 0.0;
    for (const std::size_t row : rows) {
        Total<Voxel> ofRow = 0;
        for (std::size_t x = 0; x < length; ++x) ofRow += voxels[row + x];
        sum += static_cast<double>(ofRow);
    }
    return sum;
}

/// Positions of a slab's samples relative to its axis.
struct Offsets {
    std::vector<float> x, y, z;
};

Offsets offsetsOf(const TubeSamples& tube) {
    Offsets offsets;
    const double half = (tube.cellSize - 1) / 2.0;
    for (int b = 0; b < tube.cellSize; ++b)
        for (int a = 0; a < tube.cellSize; ++a) {
            const Vec3 beside = tube.down * (b - half) + tube.right * (a - half);
            offsets.x.push_back(static_cast<float>(beside[0]));
            offsets.y.push_back(static_cast<float>(beside[1]));
            offsets.z.push_back(static_cast<float>(beside[2]));
        }
    return offsets;
}

template <typename Voxel>
class SampleTouch {
public:
    SampleTouch(const Voxel* voxels, const VolumeGeometry& geometry, const TubeSamples& any)
        : m_voxels(voxels), m_size(geometry.size), m_offsets(offsetsOf(any)) {
        const double half = (any.cellSize - 1) / 2.0;
        for (int axis = 0; axis < 3; ++axis)
            m_reach[axis] = (std::abs(any.right[axis]) + std::abs(any.down[axis])) * half;
    }

    [[nodiscard]] Total<Voxel> slab(const Vec3& centre) const {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
            inside = inside && centre[axis] - m_reach[axis] >= 0 && centre[axis] + m_reach[axis] < last(axis);
        const float x = static_cast<float>(centre[0]), y = static_cast<float>(centre[1]);
        const float z = static_cast<float>(centre[2]);
        const std::int64_t row = m_size[0], slice = m_size[0] * m_size[1];
        Total<Voxel> sum = 0;
        for (std::size_t i = 0; i < m_offsets.x.size(); ++i) {
            float atX = x + m_offsets.x[i], atY = y + m_offsets.y[i], atZ = z + m_offsets.z[i];
            if (!inside) {
                atX = std::clamp(atX, 0.0f, last(0));
                atY = std::clamp(atY, 0.0f, last(1));
                atZ = std::clamp(atZ, 0.0f, last(2));
            }
            sum += m_voxels[static_cast<int>(atX) + row * static_cast<int>(atY) + slice * static_cast<int>(atZ)];
        }
        return sum;
    }

private:
    [[nodiscard]] float last(int axis) const { return static_cast<float>(m_size[static_cast<std::size_t>(axis)] - 1); }

    const Voxel* m_voxels;
    std::array<std::int64_t, 3> m_size;
    Offsets m_offsets;
    Vec3 m_reach{0, 0, 0};
};

/// The method reads this many slabs of a tube core before it turns to the next.
constexpr int slabsPerTurn = 16;

template <typename Voxel>
double touchSamples(const Voxel* voxels, const VolumeGeometry& geometry, const std::vector<TubeSamples>& tubes,
                    std::size_t columns) {
    const SampleTouch touch(voxels, geometry, tubes.front());
    double sum = 0.0;
    for (std::size_t row = 0; row < tubes.size(); row += columns) {
        int longest = 0;
        for (std::size_t t = row; t < row + columns; ++t) longest = std::max(longest, tubes[t].slabs);
        for (int begin = 0; begin < longest; begin += slabsPerTurn)
            for (std::size_t t = row; t < row + columns; ++t)
                for (int k = begin; k < std::min(begin + slabsPerTurn, tubes[t].slabs); ++k)
                    sum += static_cast<double>(touch.slab(tubes[t].onAxis(k)));
    }
    return sum;
}

}  // namespace

Touch::Touch(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config)
    : m_volume(volume), m_columns(config.grid.columns), m_tubes(samplesOfTubes(volume, view, config)) {
    if (tubesLieOnVoxels(volume.geometry(), view)) m_rows = rowsHolding(m_tubes, volume.geometry());
}

double Touch::run() const {
    return std::visit(
        [&](const auto& voxels) {
            if (!m_rows.empty())
                return touchRows(voxels.data(), m_rows, static_cast<std::size_t>(m_volume.geometry().size[0]));
            return touchSamples(voxels.data(), m_volume.geometry(), m_tubes, static_cast<std::size_t>(m_columns));
        },
        m_volume.voxels());
}

}  // namespace echolucent::cli
