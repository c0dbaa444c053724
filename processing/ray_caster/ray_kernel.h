// One ray through the volume, front to back: Petersch 2005, eqs. 2 and 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "processing/ray_caster/brick_map.h"
#include "processing/ray_caster/lighting.h"
#include "processing/ray_caster/ray_geometry.h"
#include "processing/ray_caster/transfer_table.h"
#include "processing/ray_caster/voxel_sampler.h"

namespace echolucent::ray_casting {

template <typename Voxel, Interpolation interpolation, bool shaded>
class RayKernel {
public:
    RayKernel(const Volume& volume, const TransferTable& table, const BrickMap& bricks, const RayCastSettings& settings)
        : m_sampler(volume),
          m_lighting(volume, m_sampler, settings.shading.value_or(Shading{}), settings.camera.frame),
          m_table(table),
          m_bricks(bricks),
          m_toTable(static_cast<float>(TransferTable::intervals / volume.whiteLevel())),
          m_endTransmittance(settings.terminationTransmittance) {
        const auto& size = volume.geometry().size;
        const double sliceBytes = static_cast<double>(size[0]) * static_cast<double>(size[1]) * sizeof(Voxel);
        m_longestExtent = std::min(256.0, 0x1p29 / sliceBytes);
    }

    /// Red, green and blue times alpha, then alpha.
    [[nodiscard]] Float4 cast(const Ray& ray) const {
        Pixel pixel;
        if (carefully(ray, ray.first, ray.innerFirst, pixel) && inside(ray, pixel))
            carefully(ray, ray.innerLast, ray.last, pixel);
        return pixel.colour;
    }

private:
    struct Pixel {
        Float4 colour{0, 0, 0, 0};
        double transmittance = 1.0;  ///< in double: a product of many factors near 1 keeps its digits
    };

    /// Samples first ... last - 1 of a ray, each looking for data. False once the ray ended, like the others below.
    bool carefully(const Ray& ray, std::int64_t first, std::int64_t last, Pixel& pixel) const {
        for (std::int64_t sample = first; sample < last; ++sample)
            if (!carefully(ray, ray.position(sample), pixel)) return false;
        return true;
    }

    bool carefully(const Ray& ray, const Vec3& position, Pixel& pixel) const {
        std::optional<float> value;
        bool complete = true;
        if constexpr (interpolation == Interpolation::nearest)
            value = m_sampler.nearestCareful(position);
        else
            value = m_sampler.trilinearCareful(position, complete);
        return !value || composite(tablePosition(*value), ray, position, false, pixel);
    }

    bool inside(const Ray& ray, Pixel& pixel) const {
        for (std::int64_t sample = ray.innerFirst; sample < ray.innerLast;) {
            std::int64_t end = std::min(ray.innerLast, sample + longestRun(ray));
            BrickKind kind = BrickKind::plain;
            if (!m_bricks.allPlain()) {
                const auto brick = brickOf(ray.position(sample));
                kind = m_bricks.kindOf(brick);
                end = leavesBrick(ray, brick, sample, end);
            }
            if (kind == BrickKind::plain && !run(ray, sample, end, pixel)) return false;
            if (kind == BrickKind::careful && !carefully(ray, sample, end, pixel)) return false;
            sample = end;
        }
        return true;
    }

    /// Samples for which float positions stay far more exact than the inner box's margin, and byte offsets below 2^31.
    std::int64_t longestRun(const Ray& ray) const {
        const double fastest = std::max({std::abs(ray.step[0]), std::abs(ray.step[1]), std::abs(ray.step[2])});
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(m_longestExtent / std::max(fastest, 1.0)), 1, 256);
    }

    static std::array<std::int64_t, 3> brickOf(const Vec3& position) {
        return {static_cast<std::int64_t>(position[0]) / BrickMap::edge,
                static_cast<std::int64_t>(position[1]) / BrickMap::edge,
                static_cast<std::int64_t>(position[2]) / BrickMap::edge};
    }

    /// The first sample after `sample`, `end` at most, that lies in another brick.
    static std::int64_t leavesBrick(const Ray& ray, const std::array<std::int64_t, 3>& brick, std::int64_t sample,
                                    std::int64_t end) {
        for (int axis = 0; axis < 3; ++axis) {
            if (ray.step[axis] == 0.0) continue;
            const auto side = brick[static_cast<std::size_t>(axis)] + (ray.step[axis] > 0.0 ? 1 : 0);
            const double crossing =
                (static_cast<double>(side * BrickMap::edge) - ray.origin[axis]) / ray.step[axis] - 0.5;
            if (crossing < static_cast<double>(end)) end = static_cast<std::int64_t>(std::ceil(crossing));
        }
        end = std::max(end, sample + 1);
        // Positions change monotonically: where the last sample is in the brick, all before it are.
        while (end > sample + 1 && brickOf(ray.position(end - 1)) != brick) --end;
        return end;
    }

    bool run(const Ray& ray, std::int64_t first, std::int64_t last, Pixel& outside) const {
        const Vec3 start = ray.position(first);
        const auto corner = m_sampler.cornerOf(start, ray.position(last - 1));
        const Float4 local = corner.local(start), step = float4Of(ray.step);
        Pixel pixel = outside;  // a local copy stays in registers
        bool goesOn = true;
        constexpr int batch = 16;
        float positions[batch + runPadding];
        const auto count = static_cast<int>(last - first);
        for (int done = 0; goesOn && done < count; done += batch) {
            const int samples = std::min(batch, count - done);
            tablePositionsAlong(corner.block, interpolation, local + static_cast<float>(done) * step, step, samples,
                                m_toTable, positions);
            for (int i = 0; goesOn && i < samples; ++i) goesOn = composite(positions[i], ray, first + done + i, pixel);
        }
        outside = pixel;
        return goesOn;
    }

    bool composite(float tablePosition, const Ray& ray, std::int64_t sample, Pixel& pixel) const {
        if constexpr (std::is_same_v<Voxel, float>)
            if (tablePosition < 0.0f) return carefully(ray, ray.position(sample), pixel);
        if constexpr (shaded)
            return composite(tablePosition, ray, ray.position(sample), true, pixel);
        else
            return blend(m_table.at(tablePosition), pixel);
    }

    bool composite(float tablePosition, const Ray& ray, const Vec3& position, bool plain, Pixel& pixel) const {
        Float4 entry = m_table.at(tablePosition);
        if constexpr (shaded) {
            constexpr double worthGradient = 1.0 / 256;
            if (entry[3] == 0.0f) return true;
            const Light light = pixel.transmittance * static_cast<double>(entry[3]) < worthGradient
                                    ? m_lighting.even()
                                    : m_lighting.at(position, ray.direction, plain);
            const float alpha = entry[3], highlight = alpha * light.highlight;
            const Float4 lit = entry * light.factor + highlight;
            entry = Float4{std::min(alpha, lit[0]), std::min(alpha, lit[1]), std::min(alpha, lit[2]), alpha};
        }
        return blend(entry, pixel);
    }

    /// False where the rest of the ray can no longer be seen.
    bool blend(Float4 entry, Pixel& pixel) const {
        pixel.colour += static_cast<float>(pixel.transmittance) * entry;
        pixel.transmittance *= 1.0 - static_cast<double>(entry[3]);
        return pixel.transmittance >= m_endTransmittance;
    }

    [[nodiscard]] float tablePosition(float value) const {
        return std::min(std::max(value * m_toTable, 0.0f), static_cast<float>(TransferTable::intervals));
    }

    VoxelSampler<Voxel> m_sampler;
    Lighting<Voxel> m_lighting;
    const TransferTable& m_table;
    const BrickMap& m_bricks;
    float m_toTable;
    double m_endTransmittance;
    double m_longestExtent = 256.0;  ///< voxels on any axis
};

}  // namespace echolucent::ray_casting
