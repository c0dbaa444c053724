// Gradient shading of one sample.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "processing/ray_caster/voxel_sampler.h"

namespace echolucent::ray_casting {

/// The share of gradient-lit colour and the highlight that a sample gets.
struct Light {
    float factor;     ///< multiplies the colour
    float highlight;  ///< adds white
};

/// One directional light and the volume's scale, as Shading says it.
template <typename Voxel>
class Lighting {
public:
    Lighting(const Volume& volume, const VoxelSampler<Voxel>& sampler, const Shading& shading, const ViewFrame& frame)
        : m_sampler(sampler), m_shading(shading) {
        const Vec3& light = shading.towardsLight;
        m_towardsLight = normalized(frame.right * light[0] + frame.down * light[1] + frame.forward * light[2]);
        const VolumeGeometry& geometry = volume.geometry();
        m_white = volume.whiteLevel();
        for (int axis = 0; axis < 3; ++axis) {
            m_unitsPerVoxel[axis] = geometry.spacing[axis] / geometry.unit();
            m_reach[axis] = shading.gradientReach / m_unitsPerVoxel[axis];
        }
        const double sliceBytes = static_cast<double>(geometry.size[0] * geometry.size[1]) * sizeof(Voxel);
        m_fitsBlock = (2.0 * std::max({m_reach[0], m_reach[1], m_reach[2]}) + 3.0) * sliceBytes < 0x1p30;
    }

    /// Light where there is no surface.
    [[nodiscard]] Light even() const {
        return {static_cast<float>(m_shading.ambient + m_shading.diffuse * m_shading.evenLight), 0.0f};
    }

    /// `plain`: every voxel around carries data, where it exists.
    [[nodiscard]] Light at(const Vec3& position, const Vec3& rayDirection, bool plain) const {
        Vec3 gradient;
        const Vec3 low = position - m_reach, high = position + m_reach;
        if (plain && m_fitsBlock && isInside(low, high))
            gradient = gradientLocal(position, low);
        else if (!gradientCareful(position, gradient))
            return even();
        return lit(gradient, rayDirection);
    }

private:
    [[nodiscard]] bool isInside(const Vec3& low, const Vec3& high) const {
        constexpr double margin = 1e-3;
        for (int axis = 0; axis < 3; ++axis) {
            const auto last = static_cast<double>(m_sampler.size()[static_cast<std::size_t>(axis)] - 1);
            if (low[axis] < 0.0 || high[axis] > last - margin - (axis == 0 ? readAhead<Voxel> : 0)) return false;
        }
        return true;
    }

    [[nodiscard]] Vec3 gradientLocal(const Vec3& position, const Vec3& low) const {
        const auto corner = m_sampler.cornerOf(low, low);
        const Float4 centre = corner.local(position);
        float samples[3][8], values[8];
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(samples[axis], 8, centre[axis]);
            samples[axis][2 * axis] -= static_cast<float>(m_reach[axis]);
            samples[axis][2 * axis + 1] += static_cast<float>(m_reach[axis]);
        }
        trilinearAtEight(corner.block, samples[0], samples[1], samples[2], values);
        const double scale = 1.0 / (2.0 * m_shading.gradientReach * m_white);
        const auto rise = [&](int axis) {
            return (static_cast<double>(values[2 * axis + 1]) - static_cast<double>(values[2 * axis])) * scale;
        };
        return {rise(0), rise(1), rise(2)};
    }

    /// False where a voxel it needs has no data.
    [[nodiscard]] bool gradientCareful(const Vec3& position, Vec3& gradient) const {
        bool complete = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto last = static_cast<double>(m_sampler.size()[static_cast<std::size_t>(axis)] - 1);
            Vec3 before = position, after = position;
            before[axis] = std::clamp(position[axis] - m_reach[axis], 0.0, last);
            after[axis] = std::clamp(position[axis] + m_reach[axis], 0.0, last);
            const double units = (after[axis] - before[axis]) * m_unitsPerVoxel[axis];
            const auto low = m_sampler.trilinearCareful(before, complete);
            const auto high = m_sampler.trilinearCareful(after, complete);
            if (!complete || !low || !high) return false;
            gradient[axis] = units > 0.0 ? (static_cast<double>(*high) - static_cast<double>(*low)) / (units * m_white)
                                         : 0.0;
        }
        return true;
    }

    [[nodiscard]] Light lit(const Vec3& gradient, const Vec3& rayDirection) const {
        const double square = gradient.dot(gradient);
        const double floorSquare = m_shading.gradientFloor * m_shading.gradientFloor;
        if (!(square > 0.0)) return even();
        const double surface = square / (square + floorSquare);
        const Vec3 normal = gradient * (-1.0 / std::sqrt(square));
        const double wrap = m_shading.wrap;
        const double facing = std::max(0.0, (normal.dot(m_towardsLight) + wrap) / (1.0 + wrap));
        const double diffuse = surface * facing + (1.0 - surface) * m_shading.evenLight;
        double highlight = 0.0;
        const Vec3 half = m_towardsLight - rayDirection;
        const double along = normal.dot(half);
        if (m_shading.specular > 0.0 && along > 0.0)
            highlight = surface * m_shading.specular * std::pow(along / length(half), m_shading.specularPower);
        return {static_cast<float>(m_shading.ambient + m_shading.diffuse * diffuse), static_cast<float>(highlight)};
    }

    const VoxelSampler<Voxel>& m_sampler;
    Shading m_shading;
    Vec3 m_towardsLight, m_unitsPerVoxel, m_reach;
    double m_white = 1.0;
    bool m_fitsBlock = true;  ///< byte offsets between the samples of a gradient fit 32 bits
};

}  // namespace echolucent::ray_casting
