// Gradient shading of the samples of a ray.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "processing/ray_caster/sample_run.h"
#include "processing/ray_caster/voxel_sampler.h"

namespace echolucent::ray_casting {

/// One directional light and the volume's scale, as Shading says it.
template <typename Voxel>
class Lighting {
public:
    Lighting(const Volume& volume, const VoxelSampler<Voxel>& sampler, const Shading& shading, const ViewFrame& frame)
        : m_sampler(sampler), m_white(volume.whiteLevel()) {
        setLight(shading, frame);
        setReach(volume.geometry(), shading);
    }

    /// The light for rays in one direction.
    [[nodiscard]] DirectionalLight towards(const Vec3& rayDirection) const {
        DirectionalLight light = m_light;
        light.highlight = m_highlight.data();
        const Vec3 half = m_towardsLight - rayDirection;
        const double size = length(half);
        if (size > 0.0) light.half = float4Of(half * (1.0 / size));
        return light;
    }
    /// The factor where there is no surface.
    [[nodiscard]] float even() const { return m_light.ambient + m_light.diffuse * m_light.evenLight; }

    /// True where all voxels of a gradient exist, so that `block` serves.
    [[nodiscard]] bool isInside(const Vec3& position) const {
        return m_fitsBlock && position[0] >= m_reach[0] && position[0] <= m_insideMax[0] && position[1] >= m_reach[1] &&
               position[1] <= m_insideMax[1] && position[2] >= m_reach[2] && position[2] <= m_insideMax[2];
    }
    /// A corner from which gradients between two positions, both inside, can be taken.
    [[nodiscard]] typename VoxelSampler<Voxel>::Corner cornerOf(const Vec3& a, const Vec3& b) const {
        return m_sampler.cornerOf(a - m_reach, b - m_reach);
    }
    [[nodiscard]] Float4 reach() const { return float4Of(m_reach); }
    [[nodiscard]] float scale() const { return m_scale; }

    /// The gradient at any position; zero where a voxel it needs has no data.
    [[nodiscard]] Vec3 gradientCareful(const Vec3& position) const {
        Vec3 gradient{0, 0, 0};
        bool complete = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto last = static_cast<double>(m_sampler.size()[static_cast<std::size_t>(axis)] - 1);
            Vec3 before = position, after = position;
            before[axis] = std::clamp(position[axis] - m_reach[axis], 0.0, last);
            after[axis] = std::clamp(position[axis] + m_reach[axis], 0.0, last);
            const double units = (after[axis] - before[axis]) * m_unitsPerVoxel[axis];
            const auto low = m_sampler.trilinearCareful(before, complete);
            const auto high = m_sampler.trilinearCareful(after, complete);
            if (!complete) return {0, 0, 0};
            if (units > 0.0)
                gradient[axis] = (static_cast<double>(*high) - static_cast<double>(*low)) / (units * m_white);
        }
        return gradient;
    }

private:
    void setLight(const Shading& shading, const ViewFrame& frame) {
        const Vec3& light = shading.towardsLight;
        m_towardsLight = normalized(frame.right * light[0] + frame.down * light[1] + frame.forward * light[2]);
        m_light.towardsLight = float4Of(m_towardsLight);
        m_light.half = Float4{0, 0, 0, 0};
        m_light.ambient = static_cast<float>(shading.ambient);
        m_light.diffuse = static_cast<float>(shading.diffuse);
        m_light.evenLight = static_cast<float>(shading.evenLight);
        m_light.wrap = static_cast<float>(shading.wrap);
        m_light.floorSquare = static_cast<float>(shading.gradientFloor * shading.gradientFloor);
        for (std::size_t i = 0; i < m_highlight.size(); ++i) {
            const double cosine = std::min(1.0, static_cast<double>(i) / DirectionalLight::highlightIntervals);
            m_highlight[i] = static_cast<float>(shading.specular * std::pow(cosine, shading.specularPower));
        }
    }

    void setReach(const VolumeGeometry& geometry, const Shading& shading) {
        constexpr double margin = 1e-3;  // for the rounding of float positions
        for (int axis = 0; axis < 3; ++axis) {
            m_unitsPerVoxel[axis] = geometry.spacing[axis] / geometry.unit();
            m_reach[axis] = shading.gradientReach / m_unitsPerVoxel[axis];
            const auto last = static_cast<double>(geometry.size[static_cast<std::size_t>(axis)] - 1);
            m_insideMax[axis] = last - margin - m_reach[axis] - (axis == 0 ? readAhead : 0);
        }
        m_scale = static_cast<float>(1.0 / (2.0 * shading.gradientReach * m_white));
        const double sliceBytes = static_cast<double>(geometry.size[0] * geometry.size[1]) * sizeof(Voxel);
        m_fitsBlock = (2.0 * std::max({m_reach[0], m_reach[1], m_reach[2]}) + 3.0) * sliceBytes < 0x1p30;
    }

    const VoxelSampler<Voxel>& m_sampler;
    double m_white;
    Vec3 m_towardsLight, m_unitsPerVoxel, m_reach;
    Vec3 m_insideMax;  ///< voxels; up to there all samples of a gradient exist
    DirectionalLight m_light{};
    float m_scale = 1.0f;
    bool m_fitsBlock = true;  ///< byte offsets between the samples of a gradient fit 31 bits
    std::array<float, DirectionalLight::highlightIntervals + 2> m_highlight{};
};

}  // namespace echolucent::ray_casting
