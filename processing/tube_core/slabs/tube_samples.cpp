#include "processing/tube_core/slabs/tube_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "processing/sampling/sampler.h"

namespace echolucent {

namespace {
constexpr double rounding = 1e-9;
constexpr double noData = std::numeric_limits<double>::quiet_NaN();

/// Sets where the slabs of a tube on voxels begin, and their number. The front, seen from behind, or the view's box may
/// end the tube before the volume does.
void placeOnVoxels(const TubeAxis& axis, const VolumeGeometry& geometry, bool endsEarlier, TubeSamples& samples) {
    samples.first = *axis.entryVoxel;
    for (int component = 0; component < 3; ++component) {
        const double towards = samples.along[component];
        if (towards == 0.0) continue;
        double& position = samples.first[component];
        position = towards > 0 ? std::ceil(position - rounding) : std::floor(position + rounding);
        const double last = towards > 0 ? static_cast<double>(geometry.size[component] - 1) : 0.0;
        samples.slabs = std::max(0, static_cast<int>((last - position) * towards) + 1);
        if (!endsEarlier) continue;
        const double skipped = (position - (*axis.entryVoxel)[component]) * towards;
        samples.slabs =
            std::clamp(static_cast<int>(std::floor(*axis.lengthUnits - skipped + rounding)) + 1, 0, samples.slabs);
    }
}

}  // namespace

std::vector<TubeSamples> samplesOf(std::span<const TubeAxis> axes, const VolumeGeometry& geometry,
                                   const Viewpoint& view, int cellSize) {
    const ViewFrame frame = frameOf(view);
    const double unit = geometry.unit();
    TubeSamples common;
    common.cellSize = cellSize;
    common.onVoxels = tubesLieOnVoxels(geometry, view);
    const auto oneUnit = [&](const Vec3& direction) {
        return common.onVoxels ? direction : geometry.voxelFromGridMm(direction * unit);
    };
    common.along = oneUnit(frame.forward);
    common.right = oneUnit(frame.right);
    common.down = oneUnit(frame.down);
    std::vector<TubeSamples> all(axes.size(), common);
    for (std::size_t t = 0; t < axes.size(); ++t) {
        if (!axes[t].entryVoxel) continue;
        if (common.onVoxels) {
            placeOnVoxels(axes[t], geometry, view.frontPlane || view.cutSurface || view.box, all[t]);
            continue;
        }
        all[t].first = *axes[t].entryVoxel + common.along * 0.5;
        all[t].slabs = static_cast<int>(std::floor(*axes[t].lengthUnits + 0.5 + rounding));
    }
    return all;
}

namespace {

/// Reads interpolated intensities of one volume. The voxel type is chosen once, not for each sample.
template <typename Stored>
class Sampler {
public:
    Sampler(const Volume& volume, const Stored* voxels)
        : m_geometry(volume.geometry()),
          m_size(volume.geometry().size),
          m_voxels(voxels),
          m_mask(volume.dataMaskOrNull()),
          m_white(volume.whiteLevel()) {}

    /// The nearest voxel's intensity; half way between two voxels, the intensity of the one with the higher index. NaN
    /// outside the volume or without data.
    [[nodiscard]] double nearest(const Vec3& voxel) const {
        if (!inBox(m_geometry, voxel)) return noData;
        std::int64_t offset = 0, stride = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double last = static_cast<double>(m_size[axis] - 1);
            offset += stride * static_cast<std::int64_t>(std::floor(std::clamp(voxel[axis], 0.0, last) + 0.5));
            stride *= m_size[axis];
        }
        return m_mask == nullptr || m_mask[offset] != 0 ? value(offset) : noData;
    }

    /// The intensity, interpolated between the voxels around; the nearest voxel's if one with a share carries no data.
    /// NaN outside the volume or without data.
    [[nodiscard]] double at(const Vec3& voxel) const {
        if (!inBox(m_geometry, voxel)) return noData;
        std::array<std::int64_t, 3> low{}, high{};
        std::array<double, 3> share{};
        for (int axis = 0; axis < 3; ++axis) {
            const double last = static_cast<double>(m_size[axis] - 1);
            const double position = std::clamp(voxel[axis], 0.0, last);
            low[axis] = static_cast<std::int64_t>(position);
            share[axis] = position - static_cast<double>(low[axis]);
            high[axis] = std::min(low[axis] + 1, m_size[axis] - 1);
        }
        const std::int64_t row = m_size[0], plane = m_size[0] * m_size[1];
        std::array<std::int64_t, 8> offsets{};
        for (int corner = 0; corner < 8; ++corner)
            offsets[corner] = (corner & 1 ? high[0] : low[0]) + row * (corner & 2 ? high[1] : low[1]) +
                              plane * (corner & 4 ? high[2] : low[2]);
        if (m_mask != nullptr && touchesNoData(offsets, share)) {
            const int nearest = (share[0] >= 0.5 ? 1 : 0) + (share[1] >= 0.5 ? 2 : 0) + (share[2] >= 0.5 ? 4 : 0);
            return m_mask[offsets[nearest]] != 0 ? value(offsets[nearest]) : noData;
        }
        const auto between = [](double a, double b, double part) { return a + part * (b - a); };
        const double y0 = between(between(value(offsets[0]), value(offsets[1]), share[0]),
                                  between(value(offsets[2]), value(offsets[3]), share[0]), share[1]);
        const double y1 = between(between(value(offsets[4]), value(offsets[5]), share[0]),
                                  between(value(offsets[6]), value(offsets[7]), share[0]), share[1]);
        return between(y0, y1, share[2]);
    }

private:
    [[nodiscard]] bool touchesNoData(const std::array<std::int64_t, 8>& offsets,
                                     const std::array<double, 3>& share) const {
        for (int corner = 0; corner < 8; ++corner) {
            const bool contributes =
                (!(corner & 1) || share[0] > 0) && (!(corner & 2) || share[1] > 0) && (!(corner & 4) || share[2] > 0);
            if (contributes && m_mask[offsets[corner]] == 0) return true;
        }
        return false;
    }
    /// The normalised intensity of a voxel, clamped into [0,1]. A voxel without share may be NaN, and so may any voxel
    /// if the volume's mask was taken away. NaN counts as 0.
    [[nodiscard]] double value(std::int64_t offset) const {
        const double intensity = static_cast<double>(m_voxels[offset]) / m_white;
        return intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
    }

    const VolumeGeometry& m_geometry;
    std::array<std::int64_t, 3> m_size;
    const Stored* m_voxels;
    const std::uint8_t* m_mask;
    double m_white;
};

/// Moments of the values that are not NaN. Two passes lose no digits, even if the mean is far larger than the spread.
/// The mean is taken of deviations from the first value. So the mean of equal values is exactly their value, and their
/// spread is 0.
SlabMoments momentsOf(std::span<const double> values) {
    const auto first = std::find_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
    SlabMoments moments;
    if (first == values.end()) return moments;
    for (const double value : values)
        if (!std::isnan(value)) {
            ++moments.count;
            moments.mean += value - *first;
        }
    moments.mean = *first + moments.mean / moments.count;
    for (const double value : values)
        if (!std::isnan(value)) moments.squaredDeviations += (value - moments.mean) * (value - moments.mean);
    return moments;
}

}  // namespace

void sampleSlabs(const Volume& volume, Interpolation sampling, const TubeSamples& tube, std::vector<SlabMoments>& slabs,
                 std::vector<double>& values) {
    slabs.resize(static_cast<std::size_t>(tube.slabs));
    values.resize(static_cast<std::size_t>(tube.cellSize) * static_cast<std::size_t>(tube.cellSize));
    const double half = (tube.cellSize - 1) / 2.0;
    std::visit(
        [&](const auto& voxels) {
            const Sampler sampler(volume, voxels.data());
            for (int k = 0; k < tube.slabs; ++k) {
                std::size_t next = 0;
                for (int b = 0; b < tube.cellSize; ++b)
                    for (int a = 0; a < tube.cellSize; ++a) {
                        const Vec3 voxel =
                            tube.first + tube.along * k + tube.down * (b - half) + tube.right * (a - half);
                        values[next++] =
                            sampling == Interpolation::nearest ? sampler.nearest(voxel) : sampler.at(voxel);
                    }
                slabs[static_cast<std::size_t>(k)] = momentsOf(values);
            }
        },
        volume.voxels());
}

}  // namespace echolucent
