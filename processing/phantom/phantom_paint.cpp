// From closed-form bodies to voxels. A block that no surface can meet is filled at once. Other blocks are painted
// sample by sample, with only the primitives that can matter there.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "processing/parallel.h"
#include "processing/phantom/implicit_distance.h"
#include "processing/phantom/phantom_scene.h"
#include "processing/phantom/splitmix.h"

namespace echolucent {

namespace {

constexpr int edge = paintedEdge;

/// Depth and half width of the brightened shell inside a solid's surface, units.
constexpr double shellDepth = 1.0, shellHalfWidth = 2.5;

/// The values of one block. x runs fastest, z along the beam.
struct Block {
    SampledBlock samples;
    std::array<double, paintedSamples> echo, shadowing, fluidDistance, distance;
};

/// Slow change of gain: one wave along each axis. The seed sets each wave's phase.
struct Gain {
    std::array<std::vector<float>, 3> parts;

    Gain(const PhantomConfig& config, const std::array<std::int64_t, 3>& size) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto count = static_cast<std::size_t>(size[axis]);
            const double phase = 0x1p-64 * static_cast<double>(splitmix64(config.seed * 3 + axis + 0x6761696e));
            parts[axis].resize(count);
            for (std::size_t i = 0; i < count; ++i) {
                const double turns = (static_cast<double>(i) + 0.5) / static_cast<double>(count) + phase;
                parts[axis][i] = static_cast<float>(config.gainVariation / 3 * std::sin(2 * std::numbers::pi * turns));
            }
        }
    }
};

class Painter {
public:
    Painter(const PhantomScenery& scenery, const PhantomConfig& config, const PhantomSampling& sampling,
            std::vector<float>& echoes)
        : m_scenery(scenery),
          m_config(config),
          m_sampling(sampling),
          m_gain(config, sampling.size),
          m_echoes(echoes),
          m_unit(phantomGeometry(config).unit()),
          m_inverseRamp(inverseRampPerMm(config)) {
        m_band = std::max(0.5 * config.ramp, config.specular > 0 ? shellDepth + shellHalfWidth : 0.0) * m_unit +
                 sampling.stepMm;
    }

    /// All blocks of one column of the beam, from the probe on.
    void paintColumn(std::int64_t x0, std::int64_t y0) {
        Block block;
        Beam beam;
        beam.transmitted.fill(1.0);
        beam.fluidDistance.fill(ImplicitBody::far);
        for (std::int64_t z0 = 0; z0 < m_sampling.size[2]; z0 += edge) {
            paintBlock({x0, y0, z0}, block);
            sendBeam({x0, y0, z0}, block, beam);
        }
    }

private:
    using Index = std::array<std::int64_t, 3>;
    /// The beam's state so far, for each line of the column.
    struct Beam {
        std::array<double, edge * edge> transmitted, shadowing{}, fluidDistance;
    };

    void paintBlock(const Index& from, Block& block) {
        block.echo.fill(m_scenery.tissueEcho);
        block.shadowing.fill(0);
        block.fluidDistance.fill(ImplicitBody::far);
        m_sampling.block(from, block.samples);
        std::vector<int> active;
        for (const PhantomLayer& layer : m_scenery.layers) {
            switch (layer.body.standingOf(block.samples.centre, block.samples.radius, m_band, active)) {
                case ImplicitBody::Standing::outside: break;
                case ImplicitBody::Standing::inside:
                    block.echo.fill(layer.echo);
                    block.shadowing.fill(layer.shadowing);
                    block.fluidDistance.fill(layer.material == PhantomMaterial::fluid ? -ImplicitBody::far
                                                                                      : ImplicitBody::far);
                    break;
                case ImplicitBody::Standing::mixed:
                    measure(layer.body, active, block);
                    cover(layer, block);
                    break;
            }
        }
    }

    void measure(const ImplicitBody& body, const std::vector<int>& active, Block& block) const {
        block.distance.fill(ImplicitBody::far);
        const SampledBlock& at = block.samples;
        for (const int index : active) {
            const ImplicitBody::Term& term = body.terms()[static_cast<std::size_t>(index)];
            const double sign = term.carves ? -1.0 : 1.0;
            withDistanceFunction(term.primitive, [&](const auto& function) {
                for (std::size_t i = 0; i < paintedSamples; ++i) {
                    const double next = function(at.x[i], at.y[i], at.z[i]);
                    block.distance[i] = sign * smoothMinimum(sign * block.distance[i], next, term.seam);
                }
            });
        }
    }

    void cover(const PhantomLayer& layer, Block& block) const {
        for (std::size_t i = 0; i < paintedSamples; ++i) {
            const PaintedEcho painted = paintOver({block.echo[i], block.shadowing[i], block.fluidDistance[i]}, layer,
                                                  block.distance[i], m_inverseRamp);
            block.echo[i] = painted.echo;
            block.shadowing[i] = painted.shadowing;
            block.fluidDistance[i] = painted.fluidDistance;
        }
    }

    /// Brightening of a surface's shell by the cosine between its outward normal and the way back to the probe.
    [[nodiscard]] double specularFactor(double fluidDistance, double before) const {
        const double shell = 1 - std::abs(fluidDistance / m_unit - shellDepth) / shellHalfWidth;
        if (shell <= 0) return 1;
        const double cosine = std::clamp((fluidDistance - before) / m_sampling.stepMm, 0.0, 1.0);
        return 1 + m_config.specular * cosine * shell;
    }

    void sendBeam(const Index& from, const Block& block, Beam& beam) {
        const double depthUnits = m_sampling.stepMm / m_unit;
        const Index& size = m_sampling.size;
        const Index end{std::min(from[0] + edge, size[0]), std::min(from[1] + edge, size[1]),
                        std::min(from[2] + edge, size[2])};
        for (std::int64_t z = from[2]; z < end[2]; ++z) {
            const double reached = std::exp(-m_config.attenuation * static_cast<double>(z) * depthUnits);
            for (std::int64_t y = from[1]; y < end[1]; ++y) {
                const auto line = static_cast<std::size_t>((y - from[1]) * edge);
                const std::size_t row = static_cast<std::size_t>((z - from[2]) * edge * edge) + line;
                const float slowGain =
                    1 + m_gain.parts[1][static_cast<std::size_t>(y)] + m_gain.parts[2][static_cast<std::size_t>(z)];
                float* out = m_echoes.data() + from[0] + size[0] * (y + size[1] * z);
                for (std::size_t x = 0; x < static_cast<std::size_t>(end[0] - from[0]); ++x) {
                    double echo = block.echo[row + x];
                    if (m_config.specular > 0) {
                        echo *= specularFactor(block.fluidDistance[row + x], beam.fluidDistance[line + x]);
                        beam.fluidDistance[line + x] = block.fluidDistance[row + x];
                    }
                    if (m_config.shadow > 0) {
                        const double passed = 0.5 * (beam.shadowing[line + x] + block.shadowing[row + x]) * depthUnits;
                        beam.shadowing[line + x] = block.shadowing[row + x];
                        if (passed > 0) beam.transmitted[line + x] *= std::exp(-m_config.shadow * passed);
                        echo *= beam.transmitted[line + x];
                    }
                    const float gain = slowGain + m_gain.parts[0][static_cast<std::size_t>(from[0]) + x];
                    out[x] = static_cast<float>(echo * reached) * gain;
                }
            }
        }
    }

    const PhantomScenery& m_scenery;
    const PhantomConfig& m_config;
    const PhantomSampling& m_sampling;
    Gain m_gain;
    std::vector<float>& m_echoes;
    double m_unit, m_inverseRamp, m_band = 0;
};

}  // namespace

PhantomSampling gridSampling(const PhantomConfig& config) {
    const VolumeGeometry geometry = phantomGeometry(config);
    const Vec3 spacing = geometry.spacing;
    const double radius = 0.5 * length(Vec3((edge - 1) * spacing[0], (edge - 1) * spacing[1], (edge - 1) * spacing[2]));
    const auto block = [geometry, spacing, radius](const std::array<std::int64_t, 3>& from, SampledBlock& at) {
        const Vec3 first = geometry.gridMmFromVoxel(
            {static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2])});
        at.centre = first + Vec3(edge - 1, edge - 1, edge - 1).mul(spacing) * 0.5;
        at.radius = radius;
        std::size_t i = 0;
        for (int z = 0; z < edge; ++z)
            for (int y = 0; y < edge; ++y)
                for (int x = 0; x < edge; ++x, ++i) {
                    at.x[i] = first[0] + x * spacing[0];
                    at.y[i] = first[1] + y * spacing[1];
                    at.z[i] = first[2] + z * spacing[2];
                }
    };
    return {geometry.size, spacing[2], block};
}

std::vector<float> paintedEchoes(const PhantomScenery& scenery, const PhantomConfig& config,
                                 const PhantomSampling& sampling, const Progress& progress) {
    const auto& size = sampling.size;
    std::vector<float> echoes(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    Painter painter(scenery, config, sampling, echoes);
    const std::int64_t columns = (size[0] + edge - 1) / edge, rows = (size[1] + edge - 1) / edge;
    parallelFor(LoopRectangle<std::int64_t>(rows, columns), [&](const auto& range) {
        for (std::int64_t row = range.rows().begin(); row < range.rows().end(); ++row)
            for (std::int64_t column = range.columns().begin(); column < range.columns().end(); ++column)
                if (!progress.cancelled()) painter.paintColumn(column * edge, row * edge);
    });
    return progress.cancelled() ? std::vector<float>{} : echoes;
}

}  // namespace echolucent
