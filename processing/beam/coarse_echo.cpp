#include "processing/beam/coarse_echo.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::int64_t mostRowsOfCell = 4;

/// Where the cells of one axis begin, and last where the last cell ends.
std::vector<std::int64_t> cellEdges(std::int64_t voxels) {
    const std::int64_t voxelsOfCell = (voxels + CoarseEcho::mostCells - 1) / CoarseEcho::mostCells;
    const std::int64_t cells = voxels / voxelsOfCell;
    std::vector<std::int64_t> edges;
    for (std::int64_t i = 0; i <= cells; ++i) edges.push_back(i * voxels / cells);
    return edges;
}

/// The rows (or slices) of one cell that are read.
std::vector<std::int64_t> sampledRows(std::int64_t first, std::int64_t end) {
    const std::int64_t count = std::min(mostRowsOfCell, end - first);
    std::vector<std::int64_t> rows;
    for (std::int64_t i = 0; i < count; ++i) rows.push_back(first + (2 * i + 1) * (end - first) / (2 * count));
    return rows;
}

/// Sums over the voxels of a cell.
struct CellSum {
    double echo = 0.0;
    std::int32_t echoes = 0, data = 0, voxels = 0;
};

template <typename Voxel>
void addRow(const Voxel* voxels, const std::uint8_t* mask, const std::vector<std::int64_t>& edges,
            std::vector<CellSum>& sums) {
    using Sum = std::conditional_t<std::is_floating_point_v<Voxel>, double, std::int64_t>;
    for (std::size_t cell = 0; cell + 1 < edges.size(); ++cell) {
        Sum sum = 0;
        std::int32_t echoes = 0, data = 0;
        for (std::int64_t x = edges[cell]; x < edges[cell + 1]; ++x) {
            const bool isData = mask == nullptr || mask[x] != 0;
            const bool isEcho = isData && voxels[x] > Voxel{0};
            data += isData ? 1 : 0;
            echoes += isEcho ? 1 : 0;
            sum += isEcho ? static_cast<Sum>(voxels[x]) : Sum{0};
        }
        CellSum& total = sums[cell];
        total.echo += static_cast<double>(sum);
        total.echoes += echoes;
        total.data += data;
        total.voxels += static_cast<std::int32_t>(edges[cell + 1] - edges[cell]);
    }
}

class CellReader {
public:
    explicit CellReader(const Volume& volume) : m_volume(volume) {
        const VolumeGeometry& geometry = volume.geometry();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            m_edges[axis] = cellEdges(geometry.size[axis]);
            m_coarse.size[axis] = static_cast<int>(m_edges[axis].size()) - 1;
            m_coarse.cellMm[static_cast<int>(axis)] = geometry.spacing[static_cast<int>(axis)] *
                                                      static_cast<double>(geometry.size[axis]) / m_coarse.size[axis];
        }
        const auto cells = static_cast<std::size_t>(m_coarse.size[0]) * static_cast<std::size_t>(m_coarse.size[1]) *
                           static_cast<std::size_t>(m_coarse.size[2]);
        m_coarse.dataShare.resize(cells);
        m_coarse.echo.resize(cells);
    }

    std::optional<CoarseEcho> read(const Progress& progress) {
        const int rows = m_coarse.size[1] * m_coarse.size[2];
        parallelFor(0, rows, [&](int row) {
            if (!progress.cancelled()) readRow(row % m_coarse.size[1], row / m_coarse.size[1]);
        });
        if (progress.cancelled()) return std::nullopt;
        return std::move(m_coarse);
    }

private:
    /// Reads one row of cells along x.
    void readRow(int cellY, int cellZ) {
        const auto y = static_cast<std::size_t>(cellY), z = static_cast<std::size_t>(cellZ);
        std::vector<CellSum> sums(static_cast<std::size_t>(m_coarse.size[0]));
        const std::uint8_t* mask = m_volume.dataMaskOrNull();
        std::visit(
            [&](const auto& voxels) {
                for (const std::int64_t slice : sampledRows(m_edges[2][z], m_edges[2][z + 1]))
                    for (const std::int64_t row : sampledRows(m_edges[1][y], m_edges[1][y + 1])) {
                        const std::int64_t offset = m_volume.geometry().offset(0, row, slice);
                        addRow(voxels.data() + offset, mask != nullptr ? mask + offset : nullptr, m_edges[0], sums);
                    }
            },
            m_volume.voxels());
        const std::size_t first = y * m_coarse.stride(1) + z * m_coarse.stride(2);
        for (std::size_t x = 0; x < sums.size(); ++x) {
            const CellSum& sum = sums[x];
            m_coarse.dataShare[first + x] = static_cast<float>(sum.data) / static_cast<float>(sum.voxels);
            m_coarse.echo[first + x] = sum.echoes > 0 ? static_cast<float>(sum.echo / sum.echoes) : 0.0F;
        }
    }

    const Volume& m_volume;
    std::array<std::vector<std::int64_t>, 3> m_edges;
    CoarseEcho m_coarse;
};

}  // namespace

std::optional<CoarseEcho> coarseEchoOf(const Volume& volume, const Progress& progress) {
    return CellReader(volume).read(progress);
}

}  // namespace echolucent
