#include "processing/near_cut/smooth_echo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <opencv2/core.hpp>
#include <span>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr double cellsPerExtent = 64.0;
constexpr double smoothingCells = 1.25;  ///< standard deviation
constexpr double mostCells = 160.0;      ///< along an edge, 50 MB: sparse data in a large box get larger cells

/// A cell that a voxel reaches into along one axis, and how much of the cell the voxel covers.
struct Overlap {
    int cell;
    float share;  ///< of the cell's edge
};

/// For each voxel along an axis its overlaps with cells, in ascending order.
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

/// The voxels of a row that reach into a cell, from `first` on, and how much of the cell's edge each covers.
struct Reach {
    std::int64_t first = 0;
    std::vector<float> shares{};
};

std::vector<Reach> reachesOf(const std::vector<std::vector<Overlap>>& overlaps, int cells) {
    std::vector<Reach> reaches(static_cast<std::size_t>(cells));
    for (std::size_t voxel = 0; voxel < overlaps.size(); ++voxel)
        for (const Overlap& overlap : overlaps[voxel]) {
            Reach& reach = reaches[static_cast<std::size_t>(overlap.cell)];
            if (reach.shares.empty()) reach.first = static_cast<std::int64_t>(voxel);
            reach.shares.push_back(overlap.share);
        }
    return reaches;
}

/// Adds `numbers` times `share` to `sums`.
void add(const float* numbers, float share, std::ptrdiff_t count, float* sums) {
    for (std::ptrdiff_t i = 0; i < count; ++i) sums[i] += share * numbers[i];
}

/// Reads rows of voxels into rows of cells.
template <typename Stored>
class RowReader {
public:
    RowReader(const Volume& volume, const Stored* voxels, std::span<const Reach> cells)
        : m_voxels(voxels),
          m_mask(volume.dataMaskOrNull()),
          m_white(static_cast<float>(volume.whiteLevel())),
          m_cells(cells),
          m_intensity(static_cast<std::size_t>(volume.geometry().size[0])),
          m_isData(m_intensity.size(), 1.0F),
          m_sums(2 * cells.size()) {}

    /// For each cell two sums over the row that begins with voxel `first`: of intensity times share, and of shares.
    /// Only voxels with data count. Valid until the next call.
    [[nodiscard]] const float* sumsOf(std::int64_t first) {
        const Stored* voxels = m_voxels + first;
        for (std::size_t x = 0; x < m_intensity.size(); ++x) {
            const float stored = static_cast<float>(voxels[x]) / m_white;
            m_intensity[x] = stored > 0.0F ? std::min(stored, 1.0F) : 0.0F;  // NaN becomes 0 too
        }
        if (m_mask != nullptr) {
            const std::uint8_t* mask = m_mask + first;
            for (std::size_t x = 0; x < m_intensity.size(); ++x) {
                m_isData[x] = mask[x] != 0 ? 1.0F : 0.0F;
                m_intensity[x] *= m_isData[x];
            }
        }
        for (std::size_t cell = 0; cell < m_cells.size(); ++cell) {
            const Reach& reach = m_cells[cell];
            const float* intensity = m_intensity.data() + reach.first;
            const float* isData = m_isData.data() + reach.first;
            float echo = 0.0F, share = 0.0F;
            for (std::size_t i = 0; i < reach.shares.size(); ++i) {
                echo += reach.shares[i] * intensity[i];
                share += reach.shares[i] * isData[i];
            }
            m_sums[2 * cell] = echo;
            m_sums[2 * cell + 1] = share;
        }
        return m_sums.data();
    }

private:
    const Stored* m_voxels;
    const std::uint8_t* m_mask;
    float m_white;
    std::span<const Reach> m_cells;
    std::vector<float> m_intensity, m_isData;  ///< of each voxel of the row
    std::vector<float> m_sums;
};

double countData(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    const std::uint8_t* mask = volume.dataMaskOrNull();
    if (mask == nullptr) return static_cast<double>(geometry.voxelCount());
    std::vector<int> inSlices(static_cast<std::size_t>(geometry.size[2]));
    parallelFor(std::size_t{0}, inSlices.size(), [&](std::size_t z) {
        const std::uint8_t* slice = mask + geometry.offset(0, 0, static_cast<std::int64_t>(z));
        inSlices[z] = cv::countNonZero(cv::Mat1b(static_cast<int>(geometry.size[1]), static_cast<int>(geometry.size[0]),
                                                 const_cast<std::uint8_t*>(slice)));
    });
    return static_cast<double>(std::accumulate(inSlices.begin(), inSlices.end(), std::int64_t{0}));
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
    const auto overlaps = [&](std::size_t axis) {
        const auto i = static_cast<int>(axis);
        return overlapsAlong(geometry.size[axis], geometry.spacing[i], m_firstMm[i] - m_cellMm / 2.0, m_cellMm,
                             m_size[axis]);
    };
    const std::vector<Reach> across = reachesOf(overlaps(0), m_size[0]);
    const auto down = overlaps(1), deep = overlaps(2);
    const std::ptrdiff_t inRow = 2 * std::ptrdiff_t{m_size[0]}, inSlice = inRow * m_size[1];
    m_echo.assign(static_cast<std::size_t>(inSlice * m_size[2]), 0.0F);
    // A thread sums whole slices of cells. A slice of voxels is read twice only if it reaches into the cells of two
    // parts.
    constexpr int slicesTogether = 4;
    std::visit(
        [&](const auto& voxels) {
            parallelFor(LoopRange(0, m_size[2], slicesTogether), [&](const auto& part) {
                const auto isInPart = [&](const Overlap& overlap) {
                    return part.begin() <= overlap.cell && overlap.cell < part.end();
                };
                RowReader row(volume, voxels.data(), across);
                std::vector<float> slice(static_cast<std::size_t>(inSlice));
                for (std::int64_t z = 0; z < geometry.size[2]; ++z) {
                    const auto& cells = deep[static_cast<std::size_t>(z)];
                    if (std::ranges::none_of(cells, isInPart)) continue;
                    if (progress.cancelled()) return;
                    std::ranges::fill(slice, 0.0F);
                    for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
                        const float* sums = row.sumsOf(geometry.offset(0, y, z));
                        for (const Overlap& of : down[static_cast<std::size_t>(y)])
                            add(sums, of.share, inRow, slice.data() + of.cell * inRow);
                    }
                    for (const Overlap& of : cells)
                        if (isInPart(of)) add(slice.data(), of.share, inSlice, m_echo.data() + of.cell * inSlice);
                }
            });
        },
        volume.voxels());
    m_share.reserve(m_echo.size() / 2);
    for (std::size_t i = 1; i < m_echo.size(); i += 2) m_share.push_back(m_echo[i]);
    return !progress.cancelled();
}

void SmoothEcho::smooth() {
    const std::vector<float> kernel = gaussian(smoothingCells);
    const int reach = static_cast<int>(kernel.size() / 2);
    const std::ptrdiff_t inRow = 2 * std::ptrdiff_t{m_size[0]};
    const auto shareOf = [&](int move) { return kernel[static_cast<std::size_t>(move + reach)]; };
    parallelFor(0, m_size[1] * m_size[2], [&](int row) {
        float* smooth = m_echo.data() + row * inRow;
        const std::vector<float> before(smooth, smooth + inRow);
        std::fill_n(smooth, inRow, 0.0F);
        for (int move = -reach; move <= reach; ++move)
            add(before.data() + 2 * std::max(0, move), shareOf(move), inRow - 2 * std::abs(move),
                smooth + 2 * std::max(0, -move));
    });
    // Along y and z whole rows are added.
    const auto alongLines = [&](int lines, std::ptrdiff_t betweenLines, int length, std::ptrdiff_t step) {
        parallelFor(0, lines, [&](int line) {
            float* first = m_echo.data() + line * betweenLines;
            std::vector<float> before;
            for (int i = 0; i < length; ++i) before.insert(before.end(), first + i * step, first + i * step + inRow);
            for (int i = 0; i < length; ++i) {
                std::fill_n(first + i * step, inRow, 0.0F);
                for (int j = std::max(0, i - reach); j <= std::min(length - 1, i + reach); ++j)
                    add(before.data() + j * inRow, shareOf(j - i), inRow, first + i * step);
            }
        });
    };
    alongLines(m_size[2], inRow * m_size[1], m_size[1], inRow);
    alongLines(m_size[1], inRow, m_size[2], inRow * m_size[1]);
}

void SmoothEcho::findCentre() {
    std::array<double, 3> sum{};
    double count = 0.0;
    const float* of = m_share.data();
    for (int z = 0; z < m_size[2]; ++z)
        for (int y = 0; y < m_size[1]; ++y)
            for (int x = 0; x < m_size[0]; ++x, ++of) {
                const auto share = static_cast<double>(*of);
                sum[0] += x * share;
                sum[1] += y * share;
                sum[2] += z * share;
                count += share;
            }
    m_centreMm = m_firstMm + Vec3(sum[0], sum[1], sum[2]) * (m_cellMm / count);
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
    const std::size_t lowest = offset(low[0], low[1], low[2]);
    const auto stepX = static_cast<std::size_t>(high[0] - low[0]);
    const std::size_t stepY = offset(0, high[1] - low[1], 0), stepZ = offset(0, 0, high[2] - low[2]);
    float echo = 0.0F, weight = 0.0F, share = 0.0F;
    for (std::size_t z = 0; z < 2; ++z)
        for (std::size_t y = 0; y < 2; ++y)
            for (std::size_t x = 0; x < 2; ++x) {
                const float of = alongX[x] * alongY[y] * alongZ[z];
                const std::size_t cell = lowest + x * stepX + y * stepY + z * stepZ;
                echo += of * m_echo[2 * cell];
                weight += of * m_echo[2 * cell + 1];
                share += of * m_share[cell];
            }
    if (share < 0.5F || !(weight > 0.0F)) return std::nullopt;
    return echo / weight;
}

std::vector<float> SmoothEcho::intensities() const {
    std::vector<float> found;
    found.reserve(m_share.size());
    for (std::size_t cell = 0; cell < m_share.size(); ++cell)
        if (m_share[cell] >= 0.5F) found.push_back(m_echo[2 * cell] / m_echo[2 * cell + 1]);
    return found;
}

}  // namespace echolucent
