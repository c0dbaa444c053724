// The slow, obvious way from a volume to a picture. Tests measure the fast way against it.
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
    /// Rounds a pixel's colour and transmittance after every sample. Null: they stay in double.
    double (*rounded)(double) = nullptr;
    /// If a step adds less than this to its pixel's opacity, it is lit as if there were no surface (w = 0 of Shading),
    /// and if it adds less than leastReachedShare of this, also as if all light reached it. At 0 every step is lit by
    /// its gradient, so that pictures converge. castRays() uses min(1, step) / 128.
    double leastLitOpacity = 0.0;
    /// Whether no step is cut. Then a step counts whole if its middle is rendered, else not at all. Many volume
    /// renderers do so. A ray then errs by up to half a step at either end. On opaque faces of the box that is many
    /// levels, still at steps of 0.1.
    bool wholeSteps = false;
    /// The light that reaches a place in grid mm. It may be slow: all light reaches steps that add less than
    /// leastLitOpacity. Null: a light volume gives the light. The function must outlive the casting.
    const std::function<ReachingShares(const Vec3& gridMm)>* reaching = nullptr;
    friend bool operator==(const PlainCasting&, const PlainCasting&) = default;
};

/// One step of a ray and what it meets.
struct RaySample {
    Vec3 voxel;                       ///< the middle of the step, in voxels
    double length = 1.0;              ///< of the step's rendered part, in steps: below 1 if the step is cut
    std::optional<double> intensity;  ///< normalised; empty without data
};

/// A pixel in double: colour times alpha, alpha, and depth as in Picture::depthMm.
struct PlainPixel {
    Vec3 colour{0, 0, 0};
    double alpha = 0.0;
    double depthMm = std::numeric_limits<double>::infinity();
};

/// Casts one ray at a time, for callers that need single pixels.
class PlainCaster {
public:
    /// Volume and settings must outlive the caster. Throws std::invalid_argument for the same settings as castRays().
    PlainCaster(const Volume& volume, Classification classification, const RayCastSettings& settings,
                const PlainCasting& casting = {});

    /// A pixel of the picture that castRaysPlainly() makes, before another mode is mixed in and colours are brightened.
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
    std::optional<LightVolume> m_light;  ///< set if the shading asks for a light volume
    Classification m_classification;
    std::optional<Volume> m_gradients;  ///< set if the classification is two-dimensional
    const RayCastSettings& m_settings;
    PlainCasting m_casting;
    ray_casting::RayGeometry m_rays;
    VolumeSampler m_sampler;
    double m_nearestMm, m_farthestMm;  ///< the depths of the depth colouring's ends
    Vec3 m_towardsLight{0, 0, 0};
};

/// All steps of a pixel's ray from front to back, at the places of the picture's samples. They read the voxels as they
/// are, without the filling at the border of the data. So the time grows only with the ray's length. Throws
/// std::invalid_argument for the same settings as castRays().
[[nodiscard]] std::vector<RaySample> samplesAlongRay(const Volume& volume, const RayCastSettings& settings, int column,
                                                     int row);

/// The picture of castRays(), step by step in double. Rays and places of samples are the same. Opacity and colour come
/// straight from the classification and the colour map, without a table. Gradient magnitudes at voxels are not rounded
/// to levels. No region is skipped. A ray ends early only if terminationTransmittance is above 0, right after the step
/// that falls below it. Places in the outermost half voxel are read at the outermost voxel centres. Depth colouring is
/// applied after the light.
///
/// Empty only if the caller set progress.cancel (polled once a row). Works in the calling thread's oneTBB arena. The
/// pixels are the same for any number of threads. Throws std::invalid_argument for the same settings as castRays().
[[nodiscard]] std::optional<Picture> castRaysPlainly(const Volume& volume, const Classification& classification,
                                                     const RayCastSettings& settings, const PlainCasting& casting = {},
                                                     const Progress& progress = {});

}  // namespace echolucent
