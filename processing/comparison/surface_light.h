// How much of a picture's light comes from the surfaces that the tube cores found.
#pragma once

#include <span>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/classification.h"
#include "processing/comparison/line_samples.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The light of rays, one along the axis of each tube core with a surface and a weight. A ray's share is the part of
/// its composited intensity from within 3 units of the surface found (0 if the ray has no light). Rays begin at the
/// tube core's first sample and end where the view stops showing the axis. Samples lie one unit apart, are trilinear
/// and not shaded. If tube cores took speckle for surfaces, light near these places says nothing good of
/// an OTF (docs/comparison.md).
struct SurfaceLight {
    double meanShare = 0.0;      ///< mean over these rays, [0,1]
    double meanIntensity = 0.0;  ///< mean composited intensity, [0,1]
    int rays = 0;
};
/// `volume` holds the picture's voxels, on the grid of the volume that the tube cores read.
[[nodiscard]] SurfaceLight surfaceLight(const Volume& volume, const AdaptiveOtf& otf,
                                        const Classification& classification);
/// The same for several classifications; each equals surfaceLight()'s, bit for bit. The volume is sampled once.
[[nodiscard]] std::vector<SurfaceLight> surfaceLights(const Volume& volume, const AdaptiveOtf& otf,
                                                      std::span<const Classification> classifications);
/// The same on a sampler that other measures share. The sampler must read gradient magnitudes if a table needs them.
[[nodiscard]] std::vector<SurfaceLight> surfaceLights(const RaySampler& sampler, const AdaptiveOtf& otf,
                                                      std::span<const OpacityTable> tables);

}  // namespace echolucent
