// One ray through the volume, front to back: Petersch 2005, eqs. 2 and 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "processing/ray_caster/brick_map.h"
#include "processing/ray_caster/lighting.h"
#include "processing/ray_caster/ray_geometry.h"
#include "processing/ray_caster/sample_run.h"
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
          m_endTransmittance(settings.terminationTransmittance),
          m_shadowTint(float4Of(shadowTintOf(settings.colourMap))) {
        const auto& size = volume.geometry().size;
        const double sliceBytes = static_cast<double>(size[0] * size[1]) * sizeof(Voxel);
        m_longestExtent = std::min(256.0, 0x1p29 / sliceBytes);
    }

    /// Red, green and blue times alpha, then alpha.
    [[nodiscard]] Float4 cast(const Ray& ray) const {
        Pixel pixel;
        if constexpr (shaded) pixel.light = m_lighting.towards(ray.direction);
        if (carefully(ray, ray.first, ray.innerFirst, pixel) && inside(ray, pixel))
            carefully(ray, ray.innerLast, ray.last, pixel);
        return pixel.colour;
    }

private:
    using Corner = typename VoxelSampler<Voxel>::Corner;

    struct Pixel {
        Float4 colour{0, 0, 0, 0};
        double transmittance = 1.0;  ///< in double: a product of many factors near 1 keeps its digits
        DirectionalLight light{};    ///< shaded only
    };

    /// Samples [first, last) of a ray, each looking for data. False once the ray ended, like the others below.
    bool carefully(const Ray& ray, std::int64_t first, std::int64_t last, Pixel& pixel) const {
        Batch positions;
        for (; first < last; first += batchSize) {
            const auto count = static_cast<int>(std::min<std::int64_t>(batchSize, last - first));
            for (int i = 0; i < count; ++i)
                positions[static_cast<std::size_t>(i)] = carefulTablePosition(ray.position(first + i));
            if (!composite(positions, count, {ray, first, DataAround::masked, false}, pixel)) return false;
        }
        return true;
    }

    [[nodiscard]] float carefulTablePosition(const Vec3& position) const {
        bool complete = true;
        const std::optional<float> value = interpolation == Interpolation::nearest
                                               ? m_sampler.nearestCareful(position)
                                               : m_sampler.trilinearCareful(position, complete);
        if (!value) return noDataPosition;
        return std::min(std::max(*value * m_toTable, 0.0f), static_cast<float>(TransferTable::intervals));
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
            if (kind == BrickKind::plain && !run(ray, sample, end, DataAround::complete, pixel)) return false;
            if (kind == BrickKind::masked && !run(ray, sample, end, DataAround::masked, pixel)) return false;
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

    /// Inner samples, as vectors.
    bool run(const Ray& ray, std::int64_t first, std::int64_t last, DataAround data, Pixel& pixel) const {
        const Vec3 start = ray.position(first);
        const Corner corner = m_sampler.cornerOf(start, ray.position(last - 1));
        const Float4 local = corner.local(start), step = float4Of(ray.step);
        Batch positions;
        for (std::int64_t done = 0; done < last - first; done += batchSize) {
            const auto count = static_cast<int>(std::min<std::int64_t>(batchSize, last - first - done));
            tablePositionsAlong(corner.block, interpolation, data, {local + static_cast<float>(done) * step, step},
                                count, m_toTable, positions);
            if (!composite(positions, count, {ray, first + done, data, true}, pixel)) return false;
        }
        return true;
    }

    /// Some samples of a ray that follow each other.
    struct Samples {
        const Ray& ray;
        std::int64_t first;
        DataAround data;
        bool inner;  ///< not within the outermost half voxel
        [[nodiscard]] Vec3 position(std::size_t i) const { return ray.position(first + static_cast<std::int64_t>(i)); }
    };

    /// Blends samples behind what the pixel holds.
    bool composite(Batch& positions, int count, const Samples& samples, Pixel& pixel) const {
        if constexpr (std::is_same_v<Voxel, float>)
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
                if (positions[i] == notFinitePosition) positions[i] = carefulTablePosition(samples.position(i));
        if constexpr (shaded)
            return compositeShaded(positions, count, samples, pixel);
        else
            return compositeUnshaded(positions, count, pixel);
    }

    bool compositeUnshaded(const Batch& positions, int count, Pixel& pixel) const {
        Float4 colour = pixel.colour;  // local copies stay in registers
        double transmittance = pixel.transmittance;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            if (positions[i] < 0.0f) continue;
            const Float4 entry = m_table.at(positions[i]);
            colour += static_cast<float>(transmittance) * entry;
            transmittance *= 1.0 - static_cast<double>(entry[3]);
            if (transmittance < m_endTransmittance) break;
        }
        pixel.colour = colour;
        pixel.transmittance = transmittance;
        return transmittance >= m_endTransmittance;
    }

    /// Samples that are seen, and which of them well enough to be worth a gradient.
    struct Visible {
        std::array<Float4, batchSize> entries;  ///< colour and opacity times the transmittance before
        int count = 0;
        std::array<int, batchSize> lit;  ///< indices of those worth a gradient
        Batch litSamples;                ///< and which of the run they are
        int litCount = 0;
    };

    bool compositeShaded(const Batch& positions, int count, const Samples& samples, Pixel& pixel) const {
        constexpr float worthGradient = 1.0f / 128;
        Visible visible;
        for (int i = 0; i < count && pixel.transmittance >= m_endTransmittance; ++i) {
            const float position = positions[static_cast<std::size_t>(i)];
            if (position < 0.0f) continue;
            const Float4 entry = m_table.at(position);
            const Float4 seen = static_cast<float>(pixel.transmittance) * entry;
            pixel.transmittance *= 1.0 - static_cast<double>(entry[3]);
            if (seen[3] >= worthGradient) {
                visible.lit[static_cast<std::size_t>(visible.litCount)] = visible.count;
                visible.litSamples[static_cast<std::size_t>(visible.litCount++)] = static_cast<float>(i);
            }
            visible.entries[static_cast<std::size_t>(visible.count++)] = seen;
        }
        blend(visible, samples, pixel);
        return pixel.transmittance >= m_endTransmittance;
    }

    void blend(const Visible& visible, const Samples& samples, Pixel& pixel) const {
        Batch factors;
        if (visible.litCount > 0) {
            Gradients gradients;
            findGradients(visible, samples, gradients);
            lightOf(pixel.light, gradients, visible.litCount, factors);
        }
        Float4 colour = pixel.colour;
        const float even = m_lighting.even();
        for (int i = 0, lit = 0; i < visible.count; ++i) {
            const Float4 entry = visible.entries[static_cast<std::size_t>(i)];
            float factor = even;
            if (lit < visible.litCount && visible.lit[static_cast<std::size_t>(lit)] == i)
                factor = factors[static_cast<std::size_t>(lit++)];
            const Float4 bright = entry * factor * (m_shadowTint + (1.0f - m_shadowTint) * std::min(1.0f, factor));
            const Float4 white = Float4{0, 0, 0, 0} + entry[3];
            // Nothing is brighter than white; alpha stays what it is.
            Float4 shown = bright < white ? bright : white;
            shown[3] = entry[3];
            colour += shown;
        }
        pixel.colour = colour;
    }

    void findGradients(const Visible& visible, const Samples& samples, Gradients& gradients) const {
        const auto count = static_cast<std::size_t>(visible.litCount);
        const auto position = [&](std::size_t i) {
            return samples.position(static_cast<std::size_t>(visible.litSamples[i]));
        };
        // The box in which gradients need no care is convex: the samples inside follow each other.
        std::size_t begin = 0, end = samples.inner ? count : 0;
        while (begin < end && !m_lighting.isInside(position(begin))) ++begin;
        while (begin < end && !m_lighting.isInside(position(end - 1))) --end;
        if (begin < end) {
            const Corner corner = m_lighting.cornerOf(position(begin), position(end - 1));
            // Whole vectors are read: the others repeat a sample inside.
            Batch chosen;
            for (std::size_t i = 0; i < chosen.size(); ++i)
                chosen[i] = visible.litSamples[std::clamp(i, begin, end - 1)];
            gradientsAlong(corner.block, samples.data, {corner.local(samples.position(0)), float4Of(samples.ray.step)},
                           chosen, visible.litCount, m_lighting.reach(), m_lighting.scale(), gradients);
        }
        for (std::size_t i = 0; i < gradients.x.size(); ++i) {
            if (i >= begin && i < end) continue;
            const Vec3 gradient = i < count ? m_lighting.gradientCareful(position(i)) : Vec3(0, 0, 0);
            gradients.x[i] = static_cast<float>(gradient[0]);
            gradients.y[i] = static_cast<float>(gradient[1]);
            gradients.z[i] = static_cast<float>(gradient[2]);
        }
    }

    VoxelSampler<Voxel> m_sampler;
    Lighting<Voxel> m_lighting;
    const TransferTable& m_table;
    const BrickMap& m_bricks;
    float m_toTable;
    double m_endTransmittance;
    Float4 m_shadowTint;
    double m_longestExtent = 256.0;  ///< voxels on any axis
};

}  // namespace echolucent::ray_casting
