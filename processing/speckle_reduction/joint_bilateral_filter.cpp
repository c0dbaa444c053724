#include "processing/speckle_reduction/joint_bilateral_filter.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "processing/parallel.h"
#include "processing/per_thread.h"
#include "processing/progress_count.h"
#include "processing/speckle_reduction/filter_slabs.h"
#include "processing/speckle_reduction/filter_spacing.h"
#include "processing/speckle_reduction/guide_slices.h"
#include "processing/speckle_reduction/joint_bilateral_row.h"
#include "processing/speckle_reduction/shown_range.h"
#include "processing/speckle_reduction/speckle_law.h"

namespace echolucent {

namespace {

/// Stands for the guide of voxels that take no part: farther from every guide than 1. Its square fits into a float.
constexpr float noGuide = 1e18F;

/// Slices of a grid with a rim as wide as the taps reach, so that no voxel is special.
struct PaddedGrid {
    std::array<std::int64_t, 3> rim{}, size{};

    PaddedGrid(const VolumeGeometry& geometry, double radius, std::int64_t slices) {
        const Vec3 spacing = filterSpacing(geometry);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double reach = radius / spacing[static_cast<int>(axis)];
            rim[axis] = static_cast<std::int64_t>(std::min(reach + 1e-9, static_cast<double>(geometry.size[axis] - 1)));
            size[axis] = (axis == 2 ? slices : geometry.size[axis]) + 2 * rim[axis];
        }
    }
    [[nodiscard]] std::int64_t planeVoxels() const { return size[0] * size[1]; }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(planeVoxels() * size[2]); }
    /// The difference between the offsets of two voxels that are (x, y, z) voxels apart.
    [[nodiscard]] std::int64_t step(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return x + size[0] * (y + size[1] * z);
    }
    [[nodiscard]] std::int64_t offset(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return step(x + rim[0], y + rim[1], z + rim[2]);
    }
};

std::vector<BilateralTap> tapsOf(const PaddedGrid& grid, const Vec3& spacing, const JointBilateralPass& pass) {
    std::vector<BilateralTap> taps;
    for (std::int64_t z = -grid.rim[2]; z <= grid.rim[2]; ++z)
        for (std::int64_t y = -grid.rim[1]; y <= grid.rim[1]; ++y)
            for (std::int64_t x = -grid.rim[0]; x <= grid.rim[0]; ++x) {
                const Vec3 apart(static_cast<double>(x) * spacing[0], static_cast<double>(y) * spacing[1],
                                 static_cast<double>(z) * spacing[2]);
                const double squared = apart.dot(apart);
                if (squared > pass.radius * pass.radius + 1e-9) continue;
                const double weight = std::exp(-0.5 * squared / (pass.sigma * pass.sigma));
                taps.push_back({grid.step(x, y, z), static_cast<float>(weight)});
            }
    return taps;
}

/// SpeckleLaw::scaled() as a table over the intensity, in units of `spreads` and 0 at intensity 0.
class GuideScale {
public:
    GuideScale(const SpeckleLaw& law, double spreads) {
        for (int i = 0; i <= intervals; ++i)
            m_scaled[static_cast<std::size_t>(i)] =
                static_cast<float>((law.scaled(static_cast<double>(i) / intervals) - law.scaled(0.0)) / spreads);
    }
    [[nodiscard]] float at(float intensity) const {
        const float position = std::clamp(intensity, 0.0F, 1.0F) * static_cast<float>(intervals);
        const std::size_t low = std::min<std::size_t>(intervals - 1, static_cast<std::size_t>(position));
        return m_scaled[low] + (position - static_cast<float>(low)) * (m_scaled[low + 1] - m_scaled[low]);
    }

private:
    static constexpr int intervals = 4096;
    std::array<float, intervals + 1> m_scaled{};
};

/// One pass over normalised intensities, a slab at a time. It keeps the slices that the next slab reaches.
class JointBilateral {
public:
    /// `mostSlices` is the number of slices of the thickest slab.
    JointBilateral(const Volume& volume, const GuideScale& scale, const JointBilateralPass& pass,
                   std::int64_t mostSlices)
        : m_geometry(volume.geometry()),
          m_mask(volume.dataMaskOrNull()),
          m_scale(scale),
          m_grid(m_geometry, pass.radius, mostSlices),
          m_taps(tapsOf(m_grid, filterSpacing(m_geometry), pass)),
          m_values(m_grid.count(), 0.0F),
          m_guide(m_grid.count(), noGuide) {}

    /// The slices that this slab needs and no earlier slab has taken.
    [[nodiscard]] std::pair<std::int64_t, std::int64_t> missing(const FilterSlab& slab) const {
        const std::int64_t end = std::min(m_geometry.size[2], slab.end + m_grid.rim[2]);
        return {std::min(m_taken, end), end};
    }

    /// Goes on to the next slab. `slices` must hold the slices that missing() says of this slab.
    void advance(const FilterSlab& slab, const GuideSlices& slices) {
        const std::int64_t kept = m_taken > 0 ? 2 * m_grid.rim[2] : 0;
        const std::int64_t plane = m_grid.planeVoxels(), moved = (slab.first - m_first) * plane;
        for (std::vector<float>* floats : {&m_values, &m_guide})
            if (kept > 0 && moved > 0)
                std::copy(floats->begin() + moved, floats->begin() + moved + kept * plane, floats->begin());
        m_first = slab.first;
        const auto made = missing(slab);
        parallelFor(made.first, slab.end + m_grid.rim[2], [&](std::int64_t z) {
            if (z < made.second)
                fill(z, slices.intensities(z), slices.guide(z));
            else
                clear(z);
        });
        m_taken = std::max(m_taken, slab.end + m_grid.rim[2]);
    }

    /// Writes slice z of the newest slab to `results`. If cancelled, it stops within the slice.
    void filter(std::int64_t z, float* results, const Progress& progress) const {
        // Take rows in parts, so that the voxels within reach of a part stay in the nearest cache from row to row.
        constexpr std::int64_t part = 64;
        for (std::int64_t x = 0; x < m_geometry.size[0]; x += part)
            for (std::int64_t y = 0; y < m_geometry.size[1] && !progress.cancelled(); ++y) {
                const auto count = static_cast<std::size_t>(std::min(part, m_geometry.size[0] - x));
                const std::int64_t from = m_grid.offset(x, y, z - m_first);
                bilateralRow(m_guide.data() + from, m_values.data() + from, m_taps, count,
                             results + m_geometry.offset(x, y, 0));
            }
    }

private:
    /// Makes the plane of slice z. Voxels without data count as beyond the grid.
    void fill(std::int64_t z, const float* intensities, const float* guide) {
        const auto columns = m_geometry.size[0];
        for (std::int64_t y = 0; y < m_geometry.size[1]; ++y) {
            const std::int64_t from = columns * y, to = m_grid.offset(0, y, z - m_first);
            const std::uint8_t* const mask = m_mask != nullptr ? m_mask + m_geometry.offset(0, y, z) : nullptr;
            for (std::int64_t x = 0; x < columns; ++x) {
                const bool isData = mask == nullptr || mask[x] != 0;
                m_values[static_cast<std::size_t>(to + x)] = isData ? intensities[from + x] : 0.0F;
                m_guide[static_cast<std::size_t>(to + x)] = isData ? m_scale.at(guide[from + x]) : noGuide;
            }
        }
    }
    /// Makes the plane of a slice beyond the grid.
    void clear(std::int64_t z) {
        const std::int64_t from = (z - m_first + m_grid.rim[2]) * m_grid.planeVoxels();
        std::fill_n(m_values.begin() + from, m_grid.planeVoxels(), 0.0F);
        std::fill_n(m_guide.begin() + from, m_grid.planeVoxels(), noGuide);
    }

    const VolumeGeometry& m_geometry;
    const std::uint8_t* m_mask;
    const GuideScale& m_scale;
    PaddedGrid m_grid;
    std::vector<BilateralTap> m_taps;
    std::vector<float> m_values, m_guide;
    std::int64_t m_first = 0;  ///< the slab's first slice, behind the front rim
    std::int64_t m_taken = 0;  ///< the first slice that has no plane yet
};

/// Takes `means` of slice `z`, x fastest. Several threads call it.
using SliceTaker = std::function<void(std::int64_t z, std::span<const float> means)>;

/// One pass over a volume of any size, slab by slab.
class Pass {
public:
    Pass(const Volume& volume, const JointBilateralPass& pass, std::int64_t mostVoxels, const Progress& progress)
        : m_volume(volume),
          m_pass(pass),
          m_progress(progress),
          m_measurement(volume.geometry()),
          m_slabs(filterSlabs(volume.geometry(), m_measurement.reach(), mostVoxels,
                              tbb::this_task_arena::max_concurrency())) {}

    /// False if cancelled.
    [[nodiscard]] bool run(const SliceTaker& take) {
        constexpr double shareOfMeasuring = 0.2;
        const auto shareAt = [&](std::size_t slab, double from, double to) {
            return from + (to - from) * static_cast<double>(slab) / static_cast<double>(m_slabs.size());
        };
        // The speckle's law needs the guides of the whole volume. So make all guides for the law first, and then again,
        // slab by slab, for the means. Slices that two slabs hold are made twice. If there is only one slab, its guide
        // is made once.
        GuideSlices slices(m_volume, m_pass.guideSigma);
        for (std::size_t i = 0; i < m_slabs.size(); ++i) {
            m_progress.at(shareAt(i, 0.0, shareOfMeasuring));
            if (!slices.make(m_slabs[i].firstHeld, m_slabs[i].endHeld, m_progress)) return false;
            m_measurement.add(slices.guideVolume(), m_slabs[i]);
        }
        const GuideScale scale(m_measurement.law(), m_pass.spreads);
        JointBilateral bilateral(m_volume, scale, m_pass, m_slabs.front().end);
        for (std::size_t i = 0; i < m_slabs.size(); ++i) {
            const auto [first, end] = bilateral.missing(m_slabs[i]);
            if (m_slabs.size() > 1 && first < end && !slices.make(first, end, m_progress)) return false;
            bilateral.advance(m_slabs[i], slices);
            const double from = shareAt(i, shareOfMeasuring, 1.0), to = shareAt(i + 1, shareOfMeasuring, 1.0);
            if (!filter(bilateral, m_slabs[i], partOf(m_progress, from, to), take)) return false;
        }
        return true;
    }

private:
    [[nodiscard]] bool filter(const JointBilateral& bilateral, const FilterSlab& slab, const Progress& progress,
                              const SliceTaker& take) {
        ProgressCount count(progress, static_cast<std::size_t>(slab.end - slab.first));
        parallelFor<std::int64_t>(slab.first, slab.end, [&](std::int64_t z) {
            if (progress.cancelled()) return;
            std::vector<float>& means = m_means.local();
            bilateral.filter(z, means.data(), progress);
            take(z, means);
            count.oneDone();
        });
        return !progress.cancelled();
    }

    const Volume& m_volume;
    const JointBilateralPass& m_pass;
    const Progress& m_progress;
    SpeckleLawMeasurement m_measurement;
    std::vector<FilterSlab> m_slabs;
    PerThread<std::vector<float>> m_means{[this] {
        const auto& size = m_volume.geometry().size;
        return std::vector<float>(static_cast<std::size_t>(size[0] * size[1]));
    }};
};

/// The intensities after a pass that is not the last.
std::optional<Volume> filtered(const Volume& volume, const JointBilateralPass& pass, std::int64_t mostVoxels,
                               const Progress& progress) {
    std::vector<float> results(static_cast<std::size_t>(volume.geometry().voxelCount()));
    const bool done = Pass(volume, pass, mostVoxels, progress).run([&](std::int64_t z, std::span<const float> means) {
        std::ranges::copy(means, results.begin() + volume.geometry().offset(0, 0, z));
    });
    if (!done) return std::nullopt;
    return Volume(volume.geometry(), std::move(results), 1.0).withDataMask(volume.dataMask());
}

/// The last pass over `from`, in the type of `volume` and between its bounds.
std::optional<Volume> stored(const Volume& volume, const Volume& from, const JointBilateralPass& pass,
                             std::int64_t mostVoxels, const Progress& progress) {
    const StoredBounds bounds = storedBounds(volume);
    std::optional<Voxels> quiet = std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& read) -> std::optional<Voxels> {
            std::vector<Voxel> voxels = read.toVector();
            const bool done =
                Pass(from, pass, mostVoxels, progress).run([&](std::int64_t z, std::span<const float> means) {
                    const std::int64_t first = volume.geometry().offset(0, 0, z);
                    for (std::size_t i = 0; i < means.size(); ++i) {
                        const std::int64_t at = first + static_cast<std::int64_t>(i);
                        if (!volume.hasData(at)) continue;
                        const double mean = std::clamp(static_cast<double>(means[i]) * volume.whiteLevel(),
                                                       bounds.lowest, bounds.highest);
                        voxels[static_cast<std::size_t>(at)] =
                            static_cast<Voxel>(std::is_floating_point_v<Voxel> ? mean : mean + 0.5);
                    }
                });
            return done ? std::optional<Voxels>(std::move(voxels)) : std::nullopt;
        },
        volume.voxels());
    if (!quiet) return std::nullopt;
    return Volume(volume.geometry(), *std::move(quiet), volume.whiteLevel())
        .withValueScale(volume.valueScale())
        .withDataMask(volume.dataMask());
}

}  // namespace

std::optional<Volume> jointBilateralFiltered(const Volume& volume, std::span<const JointBilateralPass> passes,
                                             const Progress& progress, std::int64_t mostVoxels) {
    if (passes.empty()) throw std::invalid_argument("jointBilateralFiltered: there must be a pass");
    for (const JointBilateralPass& pass : passes)
        if (!(pass.guideSigma > 0.0 && pass.spreads > 0.0 && pass.radius > 0.0 && pass.sigma > 0.0))
            throw std::invalid_argument("jointBilateralFiltered: every value of a pass must be above 0");
    const double share = 1.0 / static_cast<double>(passes.size());
    std::optional<Volume> between;
    for (std::size_t i = 0; i + 1 < passes.size(); ++i) {
        const double from = share * static_cast<double>(i);
        auto next = filtered(between ? *between : volume, passes[i], mostVoxels, partOf(progress, from, from + share));
        if (!next) return std::nullopt;
        between = std::move(next);
    }
    return stored(volume, between ? *between : volume, passes.back(), mostVoxels, partOf(progress, 1.0 - share, 1.0));
}

}  // namespace echolucent
