// Light volumes: how much light reaches each place of a volume through the opacities before it (docs/light.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "processing/classification.h"
#include "processing/light/light_directions.h"
#include "processing/light/light_volume.h"
#include "processing/light/rendered_part.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/sampling/gradient_levels.h"
#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a light volume depends on beside voxels and curve.
struct LightScene {
    Vec3 towardsKey{0, 0, -1};         ///< grid mm, any length above 0
    Vec3 towardsViewer{0, 0, -1};      ///< grid mm, any length above 0
    double keyHalfAngleDegrees = 8.0;  ///< [0, 45]: half the angle under which the key light is seen; 0 has no penumbra
    RenderedPart rendered;
    /// [1, 16]: units (smallest spacing) from place to place, as whole voxels, at least one, along each axis.
    /// lightSceneOf() chooses it for a picture.
    int coarseness = 2;
    /// (0,1]: the share of the curve's extinction that attenuates light. Below 1, because most light in tissue is
    /// scattered forwards; with 1, what is seen of a surface would be half dark before anything stood before it: it
    /// lies as deep as a ray sees.
    double attenuation = 0.5;
    light::DirectionRule keyDirections = light::DirectionRule::four;      ///< that stand for the key light's cone
    light::DirectionRule aroundDirections = light::DirectionRule::seven;  ///< that stand for the hemisphere
    friend bool operator==(const LightScene&, const LightScene&) = default;
};

/// The least coarseness with which a light volume has at most `places` places, or the coarsest.
[[nodiscard]] int coarsenessWithin(const VolumeGeometry& geometry, std::int64_t places);

/// The scene of a picture of a grid: its light (settings.shading, or the default light where it is not set), its viewer
/// and what it renders. Its coarseness is the least with which it has no more places than the light of a volume of
/// usualVolumeEdge^3 voxels has at settings.lightCoarseness: light of a small volume is finer, that of a large one
/// coarser, and both cost about the same. Directions are LightScene's own.
[[nodiscard]] LightScene lightSceneOf(const RayCastSettings& settings, const VolumeGeometry& geometry);
inline constexpr int usualVolumeEdge = 216;  ///< a little more than the paper's scans have

/// What attenuates light.
struct LightOtf {
    Classification classification;
    /// Of the scan, with the largest gradient of a two-dimensional OTF, where somebody has them; where it is null, they
    /// are made where they are needed. A curve asks for none.
    const GradientLevels* gradients = nullptr;

    template <typename Otf>
    requires std::constructible_from<Classification, Otf> LightOtf(Otf otf, const GradientLevels* levels = nullptr)
        : classification(std::move(otf)), gradients(levels) {}
};

/// Makes light volumes of one volume again and again, and keeps what they have in common: the coarse opacities while
/// the curve stays (of two coarsenesses, since pictures of the hand and at rest come in turn), and, where only the key
/// light changed, the light around the viewer. Only one thread at a time may use it.
///
/// A place's light is the mean over a fixed set of directions: for the key light directions within its half-angle, for
/// the light around the viewer directions of the hemisphere before him, by the cosine. Along each the light is swept
/// from slice to slice of the grid. Light is attenuated by the curve's opacities,
/// per unit of length, by the share that LightScene::attenuation says; no data and what lies outside the
/// volume attenuate nothing, nor does what is cut away.
class LightSweep {
public:
    explicit LightSweep(std::shared_ptr<const Volume> volume);
    ~LightSweep();
    LightSweep(LightSweep&&) noexcept;
    LightSweep& operator=(LightSweep&&) noexcept;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// Follows another cut of the same scan, which marks the given rows otherwise (rowsMaskedOtherwise()): what is kept
    /// is worked out anew there alone.
    void setCut(std::shared_ptr<const Volume> volume, const RowMarks& masked);
    /// The result is empty only where progress.cancel was raised (it is polled in every slice). The work is done in the
    /// calling thread's oneTBB arena, and the bytes are the same for any number of threads. Throws
    /// std::invalid_argument for a scene out of range.
    [[nodiscard]] std::optional<LightVolume> lightVolume(const LightOtf& otf, const LightScene& scene,
                                                         const Progress& progress = {});

private:
    class Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
