// The slow, obvious route from volume to picture: what the fast one is measured against.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "processing/classification.h"
#include "processing/light/light_sweep.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/ray_caster/ray_geometry.h"
#include "processing/sampling/sampler.h"
#include "processing/volume/filled_volume.h"
#include "processing/volume/volume.h"

namespace echolucent {

struct PlainCasting {
    /// How a pixel's colour and transmittance are rounded after every sample; null: they stay in double.
    double (*rounded)(double) = nullptr;
    /// A step that adds less than this to its pixel's opacity is lit as if there were no surface (w = 0 of Shading).
    /// Where it is 0, every step is lit by its gradient, so that pictures converge; castRays() uses min(1, step) / 128.
    double leastLitOpacity = 0.0;
    /// Whether no step is cut: then each counts whole where its middle is rendered, else not at all, as many volume
    /// renderers do. A ray then errs by up to half a step at either end: on opaque faces of the box by many levels,
    /// still at steps of 0.1.
    bool wholeSteps = false;
    /// What reaches a place in grid mm, for steps that are lit by their gradient; null: a light volume says it. It must
    /// outlive the casting.
    const std::function<ReachingShares(const Vec3& gridMm)>* reaching = nullptr;
    friend bool operator==(const PlainCasting&, const PlainCasting&) = default;
};

/// What one step of a ray meets.
struct RaySample {
    Vec3 voxel;                       ///< the middle of the step, in voxels
    double length = 1.0;              ///< of what is rendered of the step, in steps: below 1 where it is cut
    std::optional<double> intensity;  ///< normalised; not set where there is no data
};

/// A pixel in double: colour times alpha, alpha, and Picture::depthMm.
struct PlainPixel {
    Vec3 colour{0, 0, 0};
    double alpha = 0.0;
    double depthMm = std::numeric_limits<double>::infinity();
};

/// Casts one ray at a time, for whoever asks for single pixels.
class PlainCaster {
public:
    /// Volume and settings must outlive the caster. Throws std::invalid_argument where castRays() does.
    PlainCaster(const Volume& volume, Classification classification, const RayCastSettings& settings,
                const PlainCasting& casting = {});

    /// As castRaysPlainly() makes it.
    [[nodiscard]] PlainPixel pixel(int column, int row) const;

private:
    struct Step;
    [[nodiscard]] PlainPixel composited(const ray_casting::Ray& ray) const;
    [[nodiscard]] PlainPixel projected(const ray_casting::Ray& ray) const;
    [[nodiscard]] double depthOf(const Vec3& voxel) const;
    [[nodiscard]] Step sampleAt(const Vec3& voxel, double length) const;
    struct Seen;
    [[nodiscard]] double presenceAt(const Vec3& voxel) const;
    [[nodiscard]] double opacityOf(const Vec3& voxel, double intensity) const;
    [[nodiscard]] Vec3 lit(const Seen& seen) const;
    [[nodiscard]] Vec3 factorsAt(const Seen& seen) const;
    [[nodiscard]] Vec3 tintAt(double depthMm) const;

    const VolumeGeometry& m_geometry;
    FilledVolume m_filled;
    std::optional<LightVolume> m_light;  ///< where the shading asks what reaches
    Classification m_classification;
    std::optional<Volume> m_gradients;  ///< where the classification is two-dimensional
    const RayCastSettings& m_settings;
    PlainCasting m_casting;
    ray_casting::RayGeometry m_rays;
    VolumeSampler m_sampler;
    double m_nearestMm, m_farthestMm;  ///< the depths of the depth colouring's ends
    Vec3 m_towardsLight{0, 0, 0};
};

/// All steps of a pixel's ray from front to back, at the places at which the picture samples. What they meet is read
/// from the voxels as they are, without the filling at the border of the data that a picture needs, so that it takes no
/// longer than the ray is. Throws std::invalid_argument where castRays() does.
[[nodiscard]] std::vector<RaySample> samplesAlongRay(const Volume& volume, const RayCastSettings& settings, int column,
                                                     int row);

/// The picture that castRays() documents, step by step in double. Rays and places of samples are the same; opacity and
/// colour come straight from the classification and the colour map, without a table, and gradient magnitudes at voxels
/// are not rounded to levels; nothing is skipped, and a ray ends early
/// only where terminationTransmittance is above 0, after the very step that falls below it. Places in the outermost
/// half voxel are read at the outermost voxel centres. Depth colouring is applied after the light.
///
/// The result is empty only where progress.cancel was raised (it is polled once a row). The work is done in the calling
/// thread's oneTBB arena, and the pixels are the same for any number of threads. Throws std::invalid_argument where
/// castRays() does.
[[nodiscard]] std::optional<Picture> castRaysPlainly(const Volume& volume, const Classification& classification,
                                                     const RayCastSettings& settings, const PlainCasting& casting = {},
                                                     const Progress& progress = {});

}  // namespace echolucent
