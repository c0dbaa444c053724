#include "processing/near_cut/smooth_echo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr double cellsPerExtent = 64.0;
constexpr double smoothingCells = 1.25;  ///< standard deviation
constexpr double mostCells = 160.0;      ///< along an edge, 50 MB: sparse data in a large box get larger cells

/// Which cells a voxel reaches into along one axis, and with how much of its extent.
struct Overlap {
    int cell;
    float share;  ///< of the cell's edge
};

/// For each voxel along an axis its overlaps, at most as many as cells it touches.
std::vector<std::vector<Overlap>> overlapsAlong(std::int64_t voxels, double spacing, double firstEdge, double cellMm,
                                                int cells) {
    std::vector<std::vector<Overlap>> all(static_cast<std::size_t>(voxels));
    for (std::int64_t voxel = 0; voxel < voxels; ++voxel) {
        const double low = ((static_cast<double>(voxel) - 0.5) * spacing - firstEdge) / cellMm;
        const double high = low + spacing / cellMm;
        const int last = std::min(cells - 1, static_cast<int>(std::floor(high)));
        for (int cell = std::max(0, static_cast<int>(std::floor(low))); cell <= last; ++cell) {
            const double share = std::min(high, cell + 1.0) - std::max(low, static_cast<double>(cell));
            if (share > 0.0) all[static_cast<std::size_t>(voxel)].push_back({cell, static_cast<float>(share)});
        }
    }
    return all;
}

struct Sums {
    std::vector<float> echo, share;
};

/// Sums one slice of voxels into a slice of cells.
template <typename Stored>
void sumSlice(const Volume& volume, const Stored* voxels, std::int64_t slice,
              const std::array<std::vector<std::vector<Overlap>>, 3>& overlaps, int columns, Sums& sums) {
    const VolumeGeometry& geometry = volume.geometry();
    const std::uint8_t* mask = volume.dataMaskOrNull();
    const auto white = static_cast<float>(volume.whiteLevel());
    std::vector<float> echo(static_cast<std::size_t>(columns)), share(static_cast<std::size_t>(columns));
    for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
        std::fill(echo.begin(), echo.end(), 0.0F);
        std::fill(share.begin(), share.end(), 0.0F);
        const std::int64_t row = geometry.offset(0, y, slice);
        for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
            if (mask != nullptr && mask[row + x] == 0) continue;
            const float stored = static_cast<float>(voxels[row + x]) / white;
            const float intensity = stored > 0.0F ? std::min(stored, 1.0F) : 0.0F;  // NaN too
            for (const Overlap& across : overlaps[0][static_cast<std::size_t>(x)]) {
                echo[static_cast<std::size_t>(across.cell)] += across.share * intensity;
                share[static_cast<std::size_t>(across.cell)] += across.share;
            }
        }
        for (const Overlap& down : overlaps[1][static_cast<std::size_t>(y)])
            for (std::size_t cell = 0; cell < echo.size(); ++cell) {
                const std::size_t place = static_cast<std::size_t>(down.cell) * echo.size() + cell;
                sums.echo[place] += down.share * echo[cell];
                sums.share[place] += down.share * share[cell];
            }
    }
}

double countData(const Volume& volume) {
    const auto& mask = volume.dataMask();
    return mask.empty() ? static_cast<double>(volume.geometry().voxelCount())
                        : static_cast<double>(mask.size()) -
                              static_cast<double>(std::count(mask.begin(), mask.end(), std::uint8_t{0}));
}

std::vector<float> gaussian(double deviation) {
    const int reach = static_cast<int>(std::ceil(3.0 * deviation));
    std::vector<float> kernel;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) sum += std::exp(-i * i / (2.0 * deviation * deviation));
    for (int i = -reach; i <= reach; ++i)
        kernel.push_back(static_cast<float>(std::exp(-i * i / (2.0 * deviation * deviation)) / sum));
    return kernel;
}

}  // namespace

std::optional<SmoothEcho> SmoothEcho::of(const Volume& volume, const Progress& progress) {
    SmoothEcho coarse;
    const double dataVoxels = countData(volume);
    if (dataVoxels == 0.0) return coarse;
    coarse.placeCells(volume, dataVoxels);
    if (!coarse.gather(volume, progress)) return std::nullopt;
    coarse.smooth();
    if (progress.cancelled()) return std::nullopt;
    coarse.findCentre();
    return coarse;
}

std::size_t SmoothEcho::offset(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(m_size[0]) *
               (static_cast<std::size_t>(y) + static_cast<std::size_t>(m_size[1]) * static_cast<std::size_t>(z));
}

void SmoothEcho::placeCells(const Volume& volume, double dataVoxels) {
    const VolumeGeometry& geometry = volume.geometry();
    const Vec3& spacing = geometry.spacing;
    const Vec3 box = geometry.boxMaxMm() - geometry.boxMinMm();
    m_extentMm = std::cbrt(dataVoxels * spacing[0] * spacing[1] * spacing[2]);
    m_cellMm = std::max(m_extentMm / cellsPerExtent, std::max({box[0], box[1], box[2]}) / mostCells);
    for (int axis = 0; axis < 3; ++axis) {
        m_size[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::ceil(box[axis] / m_cellMm - 1e-6)));
        m_firstMm[axis] = geometry.centreMm()[axis] - m_cellMm * (m_size[static_cast<std::size_t>(axis)] - 1) / 2.0;
    }
}

bool SmoothEcho::gather(const Volume& volume, const Progress& progress) {
    const VolumeGeometry& geometry = volume.geometry();
    std::array<std::vector<std::vector<Overlap>>, 3> overlaps;
    for (std::size_t axis = 0; axis < 3; ++axis)
        overlaps[axis] = overlapsAlong(geometry.size[axis], geometry.spacing[static_cast<int>(axis)],
                                       m_firstMm[static_cast<int>(axis)] - m_cellMm / 2.0, m_cellMm, m_size[axis]);
    const std::size_t inSlice = static_cast<std::size_t>(m_size[0]) * static_cast<std::size_t>(m_size[1]);
    m_cells.assign(inSlice * static_cast<std::size_t>(m_size[2]), {});
    std::vector<std::vector<std::pair<std::int64_t, float>>> slices(static_cast<std::size_t>(m_size[2]));
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (const Overlap& deep : overlaps[2][static_cast<std::size_t>(z)])
            slices[static_cast<std::size_t>(deep.cell)].emplace_back(z, deep.share);
    // A thread sums whole slices of cells: a slice of voxels that reaches into two of them is read twice.
    std::visit(
        [&](const auto& voxels) {
            parallelFor(std::size_t{0}, slices.size(), [&](std::size_t z) {
                for (const auto& [slice, share] : slices[z]) {
                    if (progress.cancelled()) return;
                    Sums sums{std::vector<float>(inSlice), std::vector<float>(inSlice)};
                    sumSlice(volume, voxels.data(), slice, overlaps, m_size[0], sums);
                    for (std::size_t cell = 0; cell < inSlice; ++cell) {
                        m_cells[z * inSlice + cell].echo += share * sums.echo[cell];
                        m_cells[z * inSlice + cell].weight += share * sums.share[cell];
                    }
                }
            });
        },
        volume.voxels());
    for (Cell& cell : m_cells) cell.share = cell.weight;
    return !progress.cancelled();
}

void SmoothEcho::smooth() {
    const std::vector<float> kernel = gaussian(smoothingCells);
    for (int axis = 0; axis < 3; ++axis) smoothAlong(axis, kernel);
}

void SmoothEcho::smoothAlong(int axis, const std::vector<float>& kernel) {
    const int reach = static_cast<int>(kernel.size() / 2), length = m_size[static_cast<std::size_t>(axis)];
    const std::size_t step = axis == 0 ? offset(1, 0, 0) : axis == 1 ? offset(0, 1, 0) : offset(0, 0, 1);
    const std::size_t lines = m_cells.size() / static_cast<std::size_t>(length);
    parallelFor(std::size_t{0}, lines, [&](std::size_t line) {
        // Lines are counted over the cells whose index along the axis is 0.
        const std::size_t first = line / step * step * static_cast<std::size_t>(length) + line % step;
        std::vector<Cell> before(static_cast<std::size_t>(length));
        for (std::size_t i = 0; i < before.size(); ++i) before[i] = m_cells[first + i * step];
        for (int i = 0; i < length; ++i) {
            float echo = 0.0F, weight = 0.0F;
            for (int j = std::max(0, i - reach); j <= std::min(length - 1, i + reach); ++j) {
                const float share = kernel[static_cast<std::size_t>(j - i + reach)];
                echo += share * before[static_cast<std::size_t>(j)].echo;
                weight += share * before[static_cast<std::size_t>(j)].weight;
            }
            Cell& cell = m_cells[first + static_cast<std::size_t>(i) * step];
            cell.echo = echo;
            cell.weight = weight;
        }
    });
}

void SmoothEcho::findCentre() {
    Vec3 sum{0, 0, 0};
    double count = 0.0;
    for (int z = 0; z < m_size[2]; ++z)
        for (int y = 0; y < m_size[1]; ++y)
            for (int x = 0; x < m_size[0]; ++x) {
                const double share = static_cast<double>(m_cells[offset(x, y, z)].share);
                sum += Vec3(x, y, z) * share;
                count += share;
            }
    m_centreMm = m_firstMm + sum * (m_cellMm / count);
}

std::optional<float> SmoothEcho::at(const Vec3& gridMm) const {
    const Vec3 place = (gridMm - m_firstMm) * (1.0 / m_cellMm);
    std::array<int, 3> low{}, high{};
    std::array<float, 3> part{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        if (!(place[axis] >= -0.5 && place[axis] <= m_size[i] - 0.5)) return std::nullopt;
        const double inside = std::clamp(place[axis], 0.0, m_size[i] - 1.0);
        low[i] = static_cast<int>(inside);
        high[i] = std::min(low[i] + 1, m_size[i] - 1);
        part[i] = static_cast<float>(inside - low[i]);
    }
    const std::array<float, 2> alongX{1.0F - part[0], part[0]}, alongY{1.0F - part[1], part[1]},
        alongZ{1.0F - part[2], part[2]};
    const Cell* lowest = &m_cells[offset(low[0], low[1], low[2])];
    const auto stepX = static_cast<std::size_t>(high[0] - low[0]);
    const std::size_t stepY = offset(0, high[1] - low[1], 0), stepZ = offset(0, 0, high[2] - low[2]);
    float echo = 0.0F, weight = 0.0F, share = 0.0F;
    for (std::size_t z = 0; z < 2; ++z)
        for (std::size_t y = 0; y < 2; ++y)
            for (std::size_t x = 0; x < 2; ++x) {
                const float of = alongX[x] * alongY[y] * alongZ[z];
                const Cell& cell = lowest[x * stepX + y * stepY + z * stepZ];
                echo += of * cell.echo;
                weight += of * cell.weight;
                share += of * cell.share;
            }
    if (share < 0.5F || !(weight > 0.0F)) return std::nullopt;
    return echo / weight;
}

std::vector<float> SmoothEcho::intensities() const {
    std::vector<float> found;
    for (const Cell& cell : m_cells)
        if (cell.share >= 0.5F) found.push_back(cell.echo / cell.weight);
    return found;
}

}  // namespace echolucent
