#include "processing/speckle_reduction/gaussian_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "processing/parallel.h"
#include "processing/per_thread.h"
#include "processing/progress_count.h"
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
    /// The weights within the axis for a position, from firstAt() on.
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

/// The memory of one thread.
struct Scratch {
    std::vector<float> sums, weights;        ///< of a slice, along z
    std::vector<float> rowSums, rowWeights;  ///< of a row, along z and y, with a rim of zeros as wide as the taps reach
    std::vector<float> lastSums, lastWeights;  ///< of a row, along all axes
};

template <typename Voxel>
class Gaussian {
public:
    /// `mask` is that of the whole grid, null if all voxels are data.
    Gaussian(const VolumeGeometry& geometry, const std::uint8_t* mask, const StoredBounds& bounds, double sigma)
        : Gaussian(geometry, mask, bounds, sigmasOf(geometry, sigma)) {}

    /// From now on reads `voxels`: slices from `firstSlice` on, x fastest, as far as the filter reaches.
    void hold(const Voxel* voxels, std::int64_t firstSlice) {
        m_held = voxels;
        m_heldFrom = offset(0, firstSlice);
    }
    /// The largest distance, in slices, of a voxel that takes part in a mean.
    [[nodiscard]] std::int64_t reach() const { return m_z.reach(); }

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

    /// Writes slice z to `results`. If cancelled, it stops within the slice.
    void filter(std::int64_t z, Scratch& scratch, Voxel* results, const Progress& progress) const {
        for (std::int64_t y = 0; y < m_rows && !progress.cancelled(); ++y) alongZ(y, z, scratch);
        for (std::int64_t y = 0; y < m_rows && !progress.cancelled(); ++y) {
            alongY(y, scratch);
            alongX(m_y.sumAt(y) * m_z.sumAt(z), scratch);
            store(offset(y, z), scratch, results + offset(y, 0));
        }
    }

private:
    Gaussian(const VolumeGeometry& geometry, const std::uint8_t* mask, const StoredBounds& bounds, const Vec3& sigmas)
        : m_columns(geometry.size[0]),
          m_rows(geometry.size[1]),
          m_mask(mask),
          m_range{static_cast<float>(bounds.lowest), static_cast<float>(bounds.highest)},
          m_x(sigmas[0], m_columns),
          m_y(sigmas[1], m_rows),
          m_z(sigmas[2], geometry.size[2]) {
        for (std::int64_t x = 0; x < m_columns; ++x) m_weightsX.push_back(m_x.sumAt(x));
    }
    /// The standard deviations along x, y and z, in voxels.
    [[nodiscard]] static Vec3 sigmasOf(const VolumeGeometry& geometry, double sigma) {
        if (!(sigma > 0.0)) throw std::invalid_argument("Gaussian: the standard deviation must be above 0");
        const Vec3 spacing = filterSpacing(geometry);
        return {sigma / spacing[0], sigma / spacing[1], sigma / spacing[2]};
    }
    [[nodiscard]] std::int64_t offset(std::int64_t y, std::int64_t z) const { return m_columns * (y + m_rows * z); }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(m_columns); }

    void alongZ(std::int64_t y, std::int64_t z, Scratch& scratch) const {
        const std::int64_t first = offset(y, m_z.firstAt(z));
        const VoxelRows<Voxel> rows{m_held + (first - m_heldFrom), m_mask ? m_mask + first : nullptr,
                                    m_columns * m_rows, count()};
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

    /// Without a mask, the weights within the grid are products of one factor per axis.
    void alongX(float weightYZ, Scratch& scratch) const {
        const auto sumUp = [&](const std::vector<float>& row, std::vector<float>& sums) {
            sumRows({row.data(), nullptr, 1, count()}, m_x.all(), sums.data(), nullptr);
        };
        sumUp(scratch.rowSums, scratch.lastSums);
        if (m_mask != nullptr) return sumUp(scratch.rowWeights, scratch.lastWeights);
        for (std::size_t x = 0; x < m_weightsX.size(); ++x) scratch.lastWeights[x] = weightYZ * m_weightsX[x];
    }

    /// Writes the row that begins at voxel `first`. Voxels without data keep their value.
    void store(std::int64_t first, const Scratch& scratch, Voxel* results) const {
        storeMeans(scratch.lastSums, scratch.lastWeights.data(), m_range, results);
        if (m_mask == nullptr) return;
        for (std::int64_t x = 0; x < m_columns; ++x)
            if (m_mask[first + x] == 0) results[x] = m_held[first + x - m_heldFrom];
    }

    std::int64_t m_columns, m_rows;
    const Voxel* m_held = nullptr;
    std::int64_t m_heldFrom = 0;  ///< the first voxel in m_held
    const std::uint8_t* m_mask;
    StoredRange m_range;
    Taps m_x, m_y, m_z;
    std::vector<float> m_weightsX;  ///< at each x, the sum of the taps within the grid
};

}  // namespace

/// A Gaussian and the memory of its threads.
struct GaussianSlices::Parts {
    Gaussian<float> gaussian;
    std::int64_t sliceVoxels;
    PerThread<Scratch> scratches{[this] { return gaussian.scratch(); }};
};

GaussianSlices::GaussianSlices(const VolumeGeometry& geometry, const std::uint8_t* mask, double sigma)
    : m_parts(new Parts{Gaussian<float>(geometry, mask, {0.0, 1.0}, sigma), geometry.size[0] * geometry.size[1]}) {}

GaussianSlices::~GaussianSlices() = default;

std::int64_t GaussianSlices::reach() const { return m_parts->gaussian.reach(); }

bool GaussianSlices::make(const float* held, std::int64_t firstHeld, std::int64_t first, std::int64_t end,
                          float* results, const Progress& progress) {
    m_parts->gaussian.hold(held, firstHeld);
    parallelFor(first, end, [&](std::int64_t z) {
        if (progress.cancelled()) return;
        m_parts->gaussian.filter(z, m_parts->scratches.local(), results + (z - first) * m_parts->sliceVoxels, progress);
    });
    return !progress.cancelled();
}

std::optional<Volume> gaussianFiltered(const Volume& volume, double sigma, const Progress& progress) {
    const VolumeGeometry& geometry = volume.geometry();
    const Volume within = withinWhite(volume);
    const StoredBounds bounds = storedBounds(volume);
    Voxels quiet = std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) -> Voxels {
            Gaussian<Voxel> gaussian(geometry, within.dataMaskOrNull(), bounds, sigma);
            gaussian.hold(voxels.data(), 0);
            std::vector<Voxel> results(voxels.size());
            PerThread<Scratch> scratches([&] { return gaussian.scratch(); });
            ProgressCount count(progress, static_cast<std::size_t>(geometry.size[2]));
            parallelFor<std::int64_t>(0, geometry.size[2], [&](std::int64_t z) {
                if (progress.cancelled()) return;
                gaussian.filter(z, scratches.local(), results.data() + geometry.offset(0, 0, z), progress);
                count.oneDone();
            });
            return results;
        },
        within.voxels());
    if (progress.cancelled()) return std::nullopt;
    return Volume(geometry, std::move(quiet), volume.whiteLevel())
        .withValueScale(volume.valueScale())
        .withDataMask(volume.dataMask());
}

}  // namespace echolucent
