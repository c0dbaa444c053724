#include "processing/speckle_reduction/gaussian_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "processing/parallel.h"
#include "processing/speckle_reduction/filter_spacing.h"
#include "processing/speckle_reduction/row_sums.h"
#include "processing/speckle_reduction/shown_range.h"

namespace echolucent {

namespace {

/// The weights of one axis; their sum is 1.
class Taps {
public:
    Taps(double sigma, std::int64_t size)
        : m_size(size), m_reach(std::min(size - 1, static_cast<std::int64_t>(std::ceil(gaussianReach * sigma)))) {
        std::vector<double> exact;
        for (std::int64_t i = -m_reach; i <= m_reach; ++i)
            exact.push_back(std::exp(-0.5 * static_cast<double>(i * i) / (sigma * sigma)));
        const double sum = std::accumulate(exact.begin(), exact.end(), 0.0);
        for (const double weight : exact) m_weights.push_back(static_cast<float>(weight / sum));
    }
    [[nodiscard]] std::int64_t reach() const { return m_reach; }
    [[nodiscard]] std::span<const float> all() const { return m_weights; }
    [[nodiscard]] std::int64_t firstAt(std::int64_t position) const {
        return std::max<std::int64_t>(0, position - m_reach);
    }
    /// The weights at a position that lie within the axis, from firstAt() on.
    [[nodiscard]] std::span<const float> at(std::int64_t position) const {
        const std::int64_t first = firstAt(position), last = std::min(m_size - 1, position + m_reach);
        return all().subspan(static_cast<std::size_t>(first - position + m_reach),
                             static_cast<std::size_t>(last - first + 1));
    }
    [[nodiscard]] float sumAt(std::int64_t position) const {
        const auto part = at(position);
        return std::accumulate(part.begin(), part.end(), 0.0F);
    }

private:
    std::int64_t m_size, m_reach;
    std::vector<float> m_weights;
};

/// What one thread works in.
struct Scratch {
    std::vector<float> sums, weights;        ///< of a slice, along z
    std::vector<float> rowSums, rowWeights;  ///< of a row, along z and y, with a rim of zeros as wide as the taps reach
    std::vector<float> lastSums, lastWeights;  ///< of a row, along all axes
};

template <typename Voxel>
class Gaussian {
public:
    Gaussian(const Volume& volume, const VoxelArray<Voxel>& voxels, const StoredBounds& bounds, const Vec3& sigmas)
        : m_columns(volume.geometry().size[0]),
          m_rows(volume.geometry().size[1]),
          m_voxels(voxels.data()),
          m_mask(volume.dataMaskOrNull()),
          m_range{static_cast<float>(bounds.lowest), static_cast<float>(bounds.highest)},
          m_x(sigmas[0], m_columns),
          m_y(sigmas[1], m_rows),
          m_z(sigmas[2], volume.geometry().size[2]) {
        for (std::int64_t x = 0; x < m_columns; ++x) m_weightsX.push_back(m_x.sumAt(x));
    }

    [[nodiscard]] Scratch scratch() const {
        const std::size_t slice = count() * static_cast<std::size_t>(m_rows);
        const std::size_t rimmed = count() + 2 * static_cast<std::size_t>(m_x.reach());
        Scratch scratch{std::vector<float>(slice), {}, std::vector<float>(rimmed), {}, std::vector<float>(count()), {}};
        scratch.lastWeights.resize(count());
        if (m_mask == nullptr) return scratch;
        scratch.weights.resize(slice);
        scratch.rowWeights.resize(rimmed);
        return scratch;
    }

    /// Writes slice z of `results`. It leaves off within the slice once the run is cancelled.
    void filter(std::int64_t z, Scratch& scratch, std::vector<Voxel>& results, const Progress& progress) const {
        for (std::int64_t y = 0; y < m_rows && !progress.cancelled(); ++y) alongZ(y, z, scratch);
        for (std::int64_t y = 0; y < m_rows && !progress.cancelled(); ++y) {
            alongY(y, scratch);
            alongX(m_y.sumAt(y) * m_z.sumAt(z), scratch);
            store(offset(y, z), scratch, results.data());
        }
    }

private:
    [[nodiscard]] std::int64_t offset(std::int64_t y, std::int64_t z) const { return m_columns * (y + m_rows * z); }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(m_columns); }

    void alongZ(std::int64_t y, std::int64_t z, Scratch& scratch) const {
        const std::int64_t first = offset(y, m_z.firstAt(z));
        const VoxelRows<Voxel> rows{m_voxels + first, m_mask ? m_mask + first : nullptr, m_columns * m_rows, count()};
        sumRows(rows, m_z.at(z), scratch.sums.data() + offset(y, 0),
                scratch.weights.data() + (m_mask ? offset(y, 0) : 0));
    }

    void alongY(std::int64_t y, Scratch& scratch) const {
        const auto sumUp = [&](const std::vector<float>& slice, std::vector<float>& row) {
            const VoxelRows<float> rows{slice.data() + offset(m_y.firstAt(y), 0), nullptr, m_columns, count()};
            sumRows(rows, m_y.at(y), row.data() + m_x.reach(), nullptr);
        };
        sumUp(scratch.sums, scratch.rowSums);
        if (m_mask != nullptr) sumUp(scratch.weights, scratch.rowWeights);
    }

    /// Without a mask the weights within the grid are products of one factor an axis.
    void alongX(float weightYZ, Scratch& scratch) const {
        const auto sumUp = [&](const std::vector<float>& row, std::vector<float>& sums) {
            sumRows({row.data(), nullptr, 1, count()}, m_x.all(), sums.data(), nullptr);
        };
        sumUp(scratch.rowSums, scratch.lastSums);
        if (m_mask != nullptr) return sumUp(scratch.rowWeights, scratch.lastWeights);
        for (std::size_t x = 0; x < m_weightsX.size(); ++x) scratch.lastWeights[x] = weightYZ * m_weightsX[x];
    }

    void store(std::int64_t first, const Scratch& scratch, Voxel* results) const {
        storeMeans(scratch.lastSums, scratch.lastWeights.data(), m_range, results + first);
        if (m_mask == nullptr) return;
        for (std::int64_t i = first; i < first + m_columns; ++i)
            if (m_mask[i] == 0) results[i] = m_voxels[i];
    }

    std::int64_t m_columns, m_rows;
    const Voxel* m_voxels;
    const std::uint8_t* m_mask;
    StoredRange m_range;
    Taps m_x, m_y, m_z;
    std::vector<float> m_weightsX;  ///< sums of the taps within the grid
};

}  // namespace

std::optional<Volume> gaussianFiltered(const Volume& volume, double sigma, const Progress& progress) {
    if (!(sigma > 0.0)) throw std::invalid_argument("gaussianFiltered: the standard deviation must be above 0");
    const VolumeGeometry& geometry = volume.geometry();
    const Vec3 spacing = filterSpacing(geometry);
    const Vec3 sigmas{sigma / spacing[0], sigma / spacing[1], sigma / spacing[2]};
    const Volume within = withinWhite(volume);
    const StoredBounds bounds = storedBounds(volume);
    Voxels quiet = std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) -> Voxels {
            const Gaussian<Voxel> gaussian(within, voxels, bounds, sigmas);
            std::vector<Voxel> results(voxels.size());
            PerThread<Scratch> scratches([&] { return gaussian.scratch(); });
            ProgressCount count(progress, static_cast<std::size_t>(geometry.size[2]));
            parallelFor<std::int64_t>(0, geometry.size[2], [&](std::int64_t z) {
                if (progress.cancelled()) return;
                gaussian.filter(z, scratches.local(), results, progress);
                count.oneDone();
            });
            return results;
        },
        within.voxels());
    if (progress.cancelled()) return std::nullopt;
    return Volume(geometry, std::move(quiet), volume.whiteLevel()).withDataMask(volume.dataMask());
}

}  // namespace echolucent
