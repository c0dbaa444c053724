// The slow, plain route to light: from every sample straight to the lights, in double. It is the reference for the
// sweeps.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "processing/light/light_directions.h"
#include "processing/light/light_sweep.h"
#include "processing/light/light_volume.h"
#include "processing/opacity_curve.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/picture/reaching_light.h"
#include "processing/progress.h"
#include "processing/sampling/sampler.h"
#include "processing/volume/volume.h"

namespace echolucent::light {

/// The light that reaches places, by marching along many directions within the lights' cones. The sweeps take other
/// directions. Along each direction the extinctions of trilinear samples add up until the volume ends or all is dark.
class ReferenceLight {
public:
    /// `volume` must outlive this object. `rings` as in denseDirectionsWithin(). `step` is the length between samples
    /// in units, above 0.
    ReferenceLight(const Volume& volume, const OpacityCurve& curve, const LightScene& scene, int rings = 4,
                   double step = 0.5);
    [[nodiscard]] ReachingShares at(const Vec3& gridMm) const;

private:
    [[nodiscard]] double along(const Vec3& gridMm, const std::vector<WeightedDirection>& directions) const;
    [[nodiscard]] double extinctionPerUnit(const Vec3& voxel) const;

    const VolumeGeometry& m_geometry;
    VolumeSampler m_sampler;
    RenderedShares m_rendered;
    double m_step, m_attenuation;
    std::vector<double> m_extinctions;  ///< per unit, over normalised intensity
    std::vector<WeightedDirection> m_key, m_around;
};

/// The shares of light that reach a place in grid mm.
using Reaching = std::function<ReachingShares(const Vec3& gridMm)>;

/// The plain route's picture (castRaysPlainly(), direct mode) with the light that reaches each sample, in double.
/// The light has the strengths of settings.shading; throws std::invalid_argument if that is not set. Samples that add
/// less than 1/2048 to their pixel are lit as if all light reached them. No value only if progress.cancel was raised.
[[nodiscard]] std::optional<Picture> castRaysInLight(const Volume& volume, const OpacityCurve& curve,
                                                     const RayCastSettings& settings, const Reaching& reaching,
                                                     const Progress& progress = {});

}  // namespace echolucent::light
