#include "processing/speckle_reduction/joint_bilateral_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "processing/parallel.h"
#include "processing/speckle_reduction/filter_spacing.h"
#include "processing/speckle_reduction/gaussian_filter.h"
#include "processing/speckle_reduction/joint_bilateral_row.h"
#include "processing/speckle_reduction/shown_range.h"
#include "processing/speckle_reduction/speckle_law.h"

namespace echolucent {

namespace {

/// Farther from every guide than any voxel that could take part; its square is a float.
constexpr float noGuide = 1e18F;

/// A rim around the grid, as wide as the taps reach, so that no voxel is special.
struct PaddedGrid {
    std::array<std::int64_t, 3> rim{}, size{};

    PaddedGrid(const VolumeGeometry& geometry, double radius) {
        const Vec3 spacing = filterSpacing(geometry);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double reach = radius / spacing[static_cast<int>(axis)];
            rim[axis] = static_cast<std::int64_t>(std::min(reach + 1e-9, static_cast<double>(geometry.size[axis] - 1)));
            size[axis] = geometry.size[axis] + 2 * rim[axis];
        }
    }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(size[0] * size[1] * size[2]); }
    /// From one voxel to another.
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

/// The speckle's scale in units of a pass's reach, tabulated.
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

/// One pass over a volume of normalised intensities, whose voxels without data are 0.
class JointBilateral {
public:
    /// Volume and guide are given free on the way: large volumes are floats four times over otherwise.
    JointBilateral(std::optional<Volume> volume, std::optional<Volume> guide, const JointBilateralPass& pass)
        : m_geometry(volume->geometry()),
          m_grid(m_geometry, pass.radius),
          m_taps(tapsOf(m_grid, filterSpacing(m_geometry), pass)),
          m_values(padded(*volume, 0.0F, [](float value) { return value; })) {
        volume.reset();
        const GuideScale scale(speckleLawOf(*guide), pass.spreads);
        m_guide = padded(*guide, noGuide, [&](float intensity) { return scale.at(intensity); });
    }

    /// Writes slice z. It leaves off within the slice once the run is cancelled.
    void filter(std::int64_t z, std::vector<float>& results, const Progress& progress) const {
        // Parts of rows, so that what the taps of a part reach stays in the nearest cache from row to row.
        constexpr std::int64_t part = 64;
        for (std::int64_t x = 0; x < m_geometry.size[0]; x += part)
            for (std::int64_t y = 0; y < m_geometry.size[1] && !progress.cancelled(); ++y) {
                const auto count = static_cast<std::size_t>(std::min(part, m_geometry.size[0] - x));
                const std::int64_t from = m_grid.offset(x, y, z);
                bilateralRow(m_guide.data() + from, m_values.data() + from, m_taps, count,
                             results.data() + m_geometry.offset(x, y, z));
            }
    }

private:
    /// What becomes of the voxels that hold data, and `rim` everywhere else.
    template <typename Become>
    [[nodiscard]] std::vector<float> padded(const Volume& volume, float rim, const Become& become) const {
        std::vector<float> values(m_grid.count(), rim);
        const auto& voxels = std::get<std::vector<float>>(volume.voxels());
        parallelFor<std::int64_t>(0, m_geometry.size[1] * m_geometry.size[2], [&](std::int64_t row) {
            std::int64_t from = row * m_geometry.size[0];
            std::int64_t to = m_grid.offset(0, row % m_geometry.size[1], row / m_geometry.size[1]);
            for (std::int64_t x = 0; x < m_geometry.size[0]; ++x, ++from, ++to)
                if (volume.hasData(from))
                    values[static_cast<std::size_t>(to)] = become(voxels[static_cast<std::size_t>(from)]);
        });
        return values;
    }

    VolumeGeometry m_geometry;
    PaddedGrid m_grid;
    std::vector<BilateralTap> m_taps;
    std::vector<float> m_values, m_guide;
};

/// What runs from one share of the whole to another.
Progress partOf(const Progress& progress, double from, double to) {
    if (!progress.report) return progress;
    return {[&progress, from, to](double share) { progress.at(from + share * (to - from)); }, progress.cancel};
}

std::optional<Volume> filtered(Volume volume, const JointBilateralPass& pass, const Progress& progress) {
    auto guide = gaussianFiltered(volume, pass.guideSigma, partOf(progress, 0.0, 0.1));
    if (!guide) return std::nullopt;
    const VolumeGeometry geometry = volume.geometry();
    const double whiteLevel = volume.whiteLevel();
    std::vector<std::uint8_t> mask = volume.dataMask();
    const JointBilateral bilateral(std::move(volume), std::move(guide), pass);
    std::vector<float> results(static_cast<std::size_t>(geometry.voxelCount()));
    const Progress rest = partOf(progress, 0.1, 1.0);
    ProgressCount count(rest, static_cast<std::size_t>(geometry.size[2]));
    parallelFor<std::int64_t>(0, geometry.size[2], [&](std::int64_t z) {
        if (progress.cancelled()) return;
        bilateral.filter(z, results, progress);
        count.oneDone();
    });
    if (progress.cancelled()) return std::nullopt;
    return Volume(geometry, std::move(results), whiteLevel).withDataMask(std::move(mask));
}

/// The volume as normalised intensities, as a picture shows them, 0 where it has no data: neither very large nor very
/// small stored values leave what a float can hold.
Volume asIntensities(const Volume& volume) {
    std::vector<float> floats(static_cast<std::size_t>(volume.geometry().voxelCount()));
    const double white = volume.whiteLevel();
    std::visit(
        [&](const auto& voxels) {
            for (std::size_t i = 0; i < voxels.size(); ++i)
                if (volume.hasData(static_cast<std::int64_t>(i)))
                    floats[i] = static_cast<float>(std::clamp(static_cast<double>(voxels[i]) / white, 0.0, 1.0));
        },
        volume.voxels());
    return Volume(volume.geometry(), std::move(floats), 1.0).withDataMask(volume.dataMask());
}

/// The results in the volume's own type and between its bounds.
Volume stored(const Volume& volume, const Volume& results) {
    const auto& means = std::get<std::vector<float>>(results.voxels());
    const StoredBounds bounds = storedBounds(volume);
    Voxels quiet = std::visit(
        [&]<typename Voxel>(std::vector<Voxel> voxels) -> Voxels {
            for (std::size_t i = 0; i < voxels.size(); ++i) {
                if (!volume.hasData(static_cast<std::int64_t>(i))) continue;
                const double mean =
                    std::clamp(static_cast<double>(means[i]) * volume.whiteLevel(), bounds.lowest, bounds.highest);
                if constexpr (std::is_floating_point_v<Voxel>)
                    voxels[i] = static_cast<Voxel>(mean);
                else
                    voxels[i] = static_cast<Voxel>(mean + 0.5);
            }
            return voxels;
        },
        volume.voxels());
    return Volume(volume.geometry(), std::move(quiet), volume.whiteLevel()).withDataMask(volume.dataMask());
}

}  // namespace

std::optional<Volume> jointBilateralFiltered(const Volume& volume, std::span<const JointBilateralPass> passes,
                                             const Progress& progress) {
    for (const JointBilateralPass& pass : passes)
        if (!(pass.guideSigma > 0.0 && pass.spreads > 0.0 && pass.radius > 0.0 && pass.sigma > 0.0))
            throw std::invalid_argument("jointBilateralFiltered: every value of a pass must be above 0");
    Volume floats = asIntensities(volume);
    const double share = 1.0 / static_cast<double>(passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const double from = share * static_cast<double>(i);
        auto next = filtered(std::move(floats), passes[i], partOf(progress, from, from + share));
        if (!next) return std::nullopt;
        floats = *std::move(next);
    }
    return stored(volume, floats);
}

}  // namespace echolucent
