// From closed-form bodies to voxels: blocks that a surface cannot meet are filled at once, the others voxel by voxel
// with only the primitives that can matter there.

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

constexpr int blockX = 8, blockY = 8, blockZ = 8;
constexpr int blockVoxels = blockX * blockY * blockZ;

/// How thick the brightened shell of a surface is, units, inside the solid.
constexpr double shellDepth = 1.0, shellHalfWidth = 2.5;

/// What one block holds; voxels in the order x fastest.
struct Block {
    std::array<double, blockVoxels> echo, shadowing, fluidDistance, distance;
};

/// Slow change of gain: one wave an axis, with a phase of its own from the seed.
struct Gain {
    std::array<std::vector<float>, 3> parts;

    Gain(const PhantomConfig& config) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto count = static_cast<std::size_t>(config.size[axis]);
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
    Painter(const PhantomScenery& scenery, const PhantomConfig& config, std::vector<float>& voxels)
        : m_scenery(scenery), m_config(config), m_geometry(phantomGeometry(config)), m_gain(config), m_voxels(voxels) {
        m_unit = m_geometry.unit();
        m_inverseRamp = inverseRampPerMm(config);
        m_band = std::max(0.5 * config.ramp, config.specular > 0 ? shellDepth + shellHalfWidth : 0.0) * m_unit +
                 m_geometry.spacing[2];
        m_blockRadius = 0.5 * length(Vec3((blockX - 1) * m_geometry.spacing[0], (blockY - 1) * m_geometry.spacing[1],
                                          (blockZ - 1) * m_geometry.spacing[2]));
    }

    /// All blocks of one column of the beam, from the probe on.
    void paintColumn(std::int64_t x0, std::int64_t y0) {
        Block block;
        Beam beam;
        beam.transmitted.fill(1.0);
        beam.fluidDistance.fill(ImplicitBody::far);
        for (std::int64_t z0 = 0; z0 < m_config.size[2]; z0 += blockZ) {
            paintBlock({x0, y0, z0}, block);
            sendBeam({x0, y0, z0}, block, beam);
        }
    }

private:
    using Index = std::array<std::int64_t, 3>;
    /// What the beam has met so far, per line of the column.
    struct Beam {
        std::array<double, blockX * blockY> transmitted, shadowing{}, fluidDistance;
    };

    void paintBlock(const Index& from, Block& block) {
        block.echo.fill(m_scenery.tissueEcho);
        block.shadowing.fill(0);
        block.fluidDistance.fill(ImplicitBody::far);
        const Vec3 first = m_geometry.gridMmFromVoxel(
            {static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2])});
        const Vec3 centre = first + Vec3((blockX - 1), (blockY - 1), (blockZ - 1)).mul(m_geometry.spacing) * 0.5;
        std::vector<int> active;
        for (const PhantomLayer& layer : m_scenery.layers) {
            switch (layer.body.standingOf(centre, m_blockRadius, m_band, active)) {
                case ImplicitBody::Standing::outside: break;
                case ImplicitBody::Standing::inside:
                    block.echo.fill(layer.echo);
                    block.shadowing.fill(layer.shadowing);
                    block.fluidDistance.fill(layer.material == PhantomMaterial::fluid ? -ImplicitBody::far
                                                                                      : ImplicitBody::far);
                    break;
                case ImplicitBody::Standing::mixed:
                    measure(layer.body, active, first, block.distance);
                    cover(layer, block);
                    break;
            }
        }
    }

    void measure(const ImplicitBody& body, const std::vector<int>& active, const Vec3& first,
                 std::array<double, blockVoxels>& distance) const {
        distance.fill(ImplicitBody::far);
        const Vec3 spacing = m_geometry.spacing;
        for (const int index : active) {
            const ImplicitBody::Term& term = body.terms()[static_cast<std::size_t>(index)];
            const double sign = term.carves ? -1.0 : 1.0;
            withDistanceFunction(term.primitive, [&](const auto& function) {
                double* value = distance.data();
                for (int z = 0; z < blockZ; ++z)
                    for (int y = 0; y < blockY; ++y)
                        for (int x = 0; x < blockX; ++x, ++value) {
                            const double next = function(first[0] + x * spacing[0], first[1] + y * spacing[1],
                                                         first[2] + z * spacing[2]);
                            *value = sign * smoothMinimum(sign * *value, next, term.seam);
                        }
            });
        }
    }

    void cover(const PhantomLayer& layer, Block& block) const {
        for (std::size_t i = 0; i < blockVoxels; ++i) {
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
        const double cosine = std::clamp((fluidDistance - before) / m_geometry.spacing[2], 0.0, 1.0);
        return 1 + m_config.specular * cosine * shell;
    }

    void sendBeam(const Index& from, const Block& block, Beam& beam) {
        const double depthUnits = m_geometry.spacing[2] / m_unit;
        const Index end{std::min(from[0] + blockX, m_config.size[0]), std::min(from[1] + blockY, m_config.size[1]),
                        std::min(from[2] + blockZ, m_config.size[2])};
        for (std::int64_t z = from[2]; z < end[2]; ++z) {
            const double reached = std::exp(-m_config.attenuation * static_cast<double>(z) * depthUnits);
            for (std::int64_t y = from[1]; y < end[1]; ++y) {
                const auto line = static_cast<std::size_t>((y - from[1]) * blockX);
                const std::size_t row = static_cast<std::size_t>((z - from[2]) * blockX * blockY) + line;
                const float slowGain =
                    1 + m_gain.parts[1][static_cast<std::size_t>(y)] + m_gain.parts[2][static_cast<std::size_t>(z)];
                float* out = m_voxels.data() + m_geometry.offset(from[0], y, z);
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
    VolumeGeometry m_geometry;
    Gain m_gain;
    std::vector<float>& m_voxels;
    double m_unit = 1, m_inverseRamp = 0, m_band = 0, m_blockRadius = 0;
};

}  // namespace

std::vector<float> paintedVoxels(const PhantomScenery& scenery, const PhantomConfig& config, const Progress& progress) {
    std::vector<float> voxels(static_cast<std::size_t>(phantomGeometry(config).voxelCount()));
    Painter painter(scenery, config, voxels);
    const std::int64_t columns = (config.size[0] + blockX - 1) / blockX, rows = (config.size[1] + blockY - 1) / blockY;
    parallelFor(tbb::blocked_range2d<std::int64_t>(0, rows, 1, 0, columns, 1), [&](const auto& range) {
        for (std::int64_t row = range.rows().begin(); row < range.rows().end(); ++row)
            for (std::int64_t column = range.cols().begin(); column < range.cols().end(); ++column)
                if (!progress.cancelled()) painter.paintColumn(column * blockX, row * blockY);
    });
    return progress.cancelled() ? std::vector<float>{} : voxels;
}

}  // namespace echolucent
