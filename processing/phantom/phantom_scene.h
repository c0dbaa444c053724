// The anatomy of the simulated scans: bodies in grid mm, painted one over the other. The voxels and the truth share it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "processing/phantom/implicit_surface.h"
#include "processing/phantom/phantom_config.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// One body and what it is made of; it covers the layers before it.
struct PhantomLayer {
    ImplicitBody body;
    PhantomMaterial material = PhantomMaterial::tissue;
    double echo = 0;       ///< mean echo, 0..255
    double shadowing = 0;  ///< share of PhantomConfig::shadow that it casts, [0,1]
};

struct PhantomScenery {
    double tissueEcho = 0;  ///< mean echo of uncovered places, 0..255
    std::vector<PhantomLayer> layers;
};

/// Echo and shadowing of the painted layers, ramps included. paintOver() paints a layer at a signed distance (mm) from
/// its body.
struct PaintedEcho {
    double echo = 0;
    double shadowing = 0;
    double fluidDistance = ImplicitBody::far;  ///< signed distance to the fluid (mm), negative in it
};
[[nodiscard]] inline PaintedEcho paintOver(PaintedEcho below, const PhantomLayer& layer, double distance,
                                           double inverseRampMm) {
    const double cover = std::clamp(0.5 - distance * inverseRampMm, 0.0, 1.0);
    below.echo += cover * (layer.echo - below.echo);
    below.shadowing += cover * (layer.shadowing - below.shadowing);
    below.fluidDistance = layer.material == PhantomMaterial::fluid ? std::min(below.fluidDistance, distance)
                                                                   : std::max(below.fluidDistance, -distance);
    return below;
}

/// 1 / width of the ramp in mm; a ramp of 0 becomes a step.
[[nodiscard]] double inverseRampPerMm(const PhantomConfig& config);
/// Grid geometry of the phantom. Throws std::invalid_argument if the config makes no sense.
[[nodiscard]] VolumeGeometry phantomGeometry(const PhantomConfig& config);

/// The scene's layers, laid out relative to the volume's extent in mm. They have one scale for all axes (the smallest
/// extent). They are centred across the beam and begin at the probe's face. A front wall, if any, is the last layer.
[[nodiscard]] PhantomScenery buildScenery(const PhantomConfig& config);

/// The frame of drawings: [0,1] across the smallest extent, x and y centred at 0.5, z from the probe's face.
[[nodiscard]] Placement sceneryPose(const VolumeGeometry& geometry);

void addShapes(PhantomScenery& scenery, const Placement& placement, const PhantomConfig& config);
void addFetus(PhantomScenery& scenery, const Placement& placement, const PhantomConfig& config);

/// The edge of a block, samples. Painting goes block by block.
constexpr int paintedEdge = 8;
constexpr int paintedSamples = paintedEdge * paintedEdge * paintedEdge;

/// The places of one block's samples, grid mm; the first index runs fastest. Some may lie beyond the last index.
struct SampledBlock {
    std::array<double, paintedSamples> x, y, z;
    Vec3 centre;
    double radius = 0;  ///< of a ball around the centre that holds all samples
};

/// The places at which the scene is sampled. The last index runs along the beam, away from the probe.
struct PhantomSampling {
    std::array<std::int64_t, 3> size{1, 1, 1};
    double stepMm = 1;  ///< along the beam
    /// The block that begins at an index.
    std::function<void(const std::array<std::int64_t, 3>& first, SampledBlock& block)> block;
};
/// Samples at the voxels of the config's grid.
[[nodiscard]] PhantomSampling gridSampling(const PhantomConfig& config);

/// The noise-free echo of every sample, with specular brightening, shadow, attenuation and gain along the beam. The
/// first index runs fastest. Empty only if cancelled.
[[nodiscard]] std::vector<float> paintedEchoes(const PhantomScenery& scenery, const PhantomConfig& config,
                                               const PhantomSampling& sampling, const Progress& progress);

}  // namespace echolucent
