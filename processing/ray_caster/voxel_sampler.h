// Reading the volume between its voxel centres.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "processing/ray_caster/sample_run.h"
#include "processing/ray_caster/transfer_table.h"
#include "processing/volume.h"

namespace echolucent::ray_casting {

inline Float4 float4Of(const Vec3& v) {
    return Float4{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0.0f};
}

/// Samples of stored values at any position in the volume's box: clamped to the outermost voxel centres, voxels without
/// data left out. And corners from which sample_run.h takes samples where all voxels around exist and carry data.
template <typename Voxel>
class VoxelSampler {
public:
    explicit VoxelSampler(const Volume& volume)
        : m_voxels(std::get<std::vector<Voxel>>(volume.voxels()).data()),
          m_mask(volume.dataMask().empty() ? nullptr : volume.dataMask().data()),
          m_size(volume.geometry().size),
          m_rowStride(static_cast<std::ptrdiff_t>(m_size[0])),
          m_sliceStride(static_cast<std::ptrdiff_t>(m_size[0] * m_size[1])) {}

    /// A corner from which positions are counted, in voxels; the floats stay small and so exact.
    struct Corner {
        std::array<std::int64_t, 3> voxel;
        VoxelBlock<Voxel> block;

        [[nodiscard]] Float4 local(const Vec3& position) const {
            return Float4{static_cast<float>(position[0] - static_cast<double>(voxel[0])),
                          static_cast<float>(position[1] - static_cast<double>(voxel[1])),
                          static_cast<float>(position[2] - static_cast<double>(voxel[2])), 0.0f};
        }
    };
    /// The corner at the smaller cell of two positions, on each axis; both at or beyond the first voxel centre.
    [[nodiscard]] Corner cornerOf(const Vec3& a, const Vec3& b) const {
        Corner corner{};
        for (int axis = 0; axis < 3; ++axis)
            corner.voxel[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::min(a[axis], b[axis]));
        const std::ptrdiff_t offset = corner.voxel[0] + m_rowStride * corner.voxel[1] + m_sliceStride * corner.voxel[2];
        corner.block.first = m_voxels + offset;
        corner.block.mask = m_mask == nullptr ? nullptr : m_mask + offset;
        corner.block.rowStride = static_cast<std::int32_t>(m_rowStride);
        corner.block.sliceStride = static_cast<std::int32_t>(m_sliceStride);
        return corner;
    }

    /// Mean of the voxels with data around a position by their trilinear weights; none where they weigh less than half.
    /// `complete` becomes false where a voxel of more than missingWeight has no data.
    [[nodiscard]] std::optional<float> trilinearCareful(const Vec3& position, bool& complete) const {
        Indices low, high;
        std::array<double, 3> share;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double last = static_cast<double>(m_size[axis] - 1);
            const double inside = std::clamp(position[static_cast<int>(axis)], 0.0, last);
            low[axis] = static_cast<std::ptrdiff_t>(inside);
            high[axis] = std::min<std::ptrdiff_t>(low[axis] + 1, static_cast<std::ptrdiff_t>(m_size[axis] - 1));
            share[axis] = inside - static_cast<double>(low[axis]);
        }
        if constexpr (std::is_integral_v<Voxel>)
            if (m_mask == nullptr) return static_cast<float>(completeMean(low, high, share));
        double sum = 0.0, weights = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const bool right = corner & 1, down = corner & 2, behind = corner & 4;
            const double weight = (right ? share[0] : 1 - share[0]) * (down ? share[1] : 1 - share[1]) *
                                  (behind ? share[2] : 1 - share[2]);
            if (weight == 0.0) continue;
            const std::ptrdiff_t offset = (right ? high[0] : low[0]) + m_rowStride * (down ? high[1] : low[1]) +
                                          m_sliceStride * (behind ? high[2] : low[2]);
            if (!hasData(offset)) {
                complete = complete && weight <= missingWeight;
                continue;
            }
            sum += weight * static_cast<double>(m_voxels[offset]);
            weights += weight;
        }
        if (weights < 0.5) return std::nullopt;
        return static_cast<float>(sum / weights);
    }
    [[nodiscard]] std::optional<float> nearestCareful(const Vec3& position) const {
        std::array<std::ptrdiff_t, 3> voxel;
        for (std::size_t axis = 0; axis < 3; ++axis)
            voxel[axis] = std::clamp(static_cast<std::ptrdiff_t>(std::floor(position[static_cast<int>(axis)] + 0.5)),
                                     std::ptrdiff_t{0}, static_cast<std::ptrdiff_t>(m_size[axis] - 1));
        const std::ptrdiff_t offset = voxel[0] + m_rowStride * voxel[1] + m_sliceStride * voxel[2];
        if (!hasData(offset)) return std::nullopt;
        return static_cast<float>(m_voxels[offset]);
    }

    [[nodiscard]] const std::array<std::int64_t, 3>& size() const { return m_size; }

private:
    using Indices = std::array<std::ptrdiff_t, 3>;

    /// Trilinear interpolation where every voxel carries data.
    [[nodiscard]] double completeMean(const Indices& low, const Indices& high,
                                      const std::array<double, 3>& share) const {
        const auto alongX = [&](std::ptrdiff_t row) {
            const double left = static_cast<double>(m_voxels[row + low[0]]);
            return left + share[0] * (static_cast<double>(m_voxels[row + high[0]]) - left);
        };
        const auto alongXY = [&](std::ptrdiff_t slice) {
            const double above = alongX(slice + m_rowStride * low[1]);
            return above + share[1] * (alongX(slice + m_rowStride * high[1]) - above);
        };
        const double before = alongXY(m_sliceStride * low[2]);
        return before + share[2] * (alongXY(m_sliceStride * high[2]) - before);
    }

    [[nodiscard]] bool hasData(std::ptrdiff_t offset) const {
        return (m_mask == nullptr || m_mask[offset] != 0) && std::isfinite(static_cast<float>(m_voxels[offset]));
    }

    const Voxel* m_voxels;
    const std::uint8_t* m_mask;
    std::array<std::int64_t, 3> m_size;
    std::ptrdiff_t m_rowStride, m_sliceStride;
};

}  // namespace echolucent::ray_casting
