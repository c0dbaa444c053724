// Light volumes: how much light reaches each place of a volume through the opacities on its way (docs/light.md).
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

/// What a light volume depends on besides voxels and OTF.
struct LightScene {
    Vec3 towardsKey{0, 0, -1};         ///< grid mm, any length above 0
    Vec3 towardsViewer{0, 0, -1};      ///< grid mm, any length above 0
    double keyHalfAngleDegrees = 8.0;  ///< [0, 45]: half the angle of the key light's cone; 0 has no penumbra
    RenderedPart rendered;
    /// [1, 16]: units (smallest spacing) from place to place along each axis, rounded to whole voxels, at least one.
    /// lightSceneOf() chooses the coarseness for a picture.
    int coarseness = 2;
    /// (0,1]: the share of the curve's extinction that attenuates light. The default is below 1, because tissue
    /// scatters most light forwards. With 1, a surface would be half dark with nothing before it, because rays see some
    /// way into the surface.
    double attenuation = 0.5;
    light::DirectionRule keyDirections = light::DirectionRule::four;      ///< that stand for the key light's cone
    light::DirectionRule aroundDirections = light::DirectionRule::seven;  ///< that stand for the hemisphere
    friend bool operator==(const LightScene&, const LightScene&) = default;
};

/// The least coarseness with which a light volume has at most `places` places, or the coarsest.
[[nodiscard]] int coarsenessWithin(const VolumeGeometry& geometry, std::int64_t places);

/// The light scene of a picture of a grid: its light (settings.shading, or the default light if not set), its viewer
/// and the part that it renders. Its coarseness is the least within this number of places: as many as a volume of
/// usualVolumeEdge^3 voxels has at settings.lightCoarseness. So small volumes have finer light than large ones, and all
/// cost about the same. The directions are LightScene's defaults.
[[nodiscard]] LightScene lightSceneOf(const RayCastSettings& settings, const VolumeGeometry& geometry);
inline constexpr int usualVolumeEdge = 216;  ///< a little more than the paper's scans have

/// What attenuates light.
struct LightOtf {
    Classification classification;
    /// The gradients of the scan up to the OTF's largest, if the caller has them. If null, lightVolume() makes them for
    /// a two-dimensional OTF. A curve needs none.
    const GradientLevels* gradients = nullptr;

    template <typename Otf>
    requires std::constructible_from<Classification, Otf> LightOtf(Otf otf, const GradientLevels* levels = nullptr)
        : classification(std::move(otf)), gradients(levels) {}
};

/// Makes light volumes of one volume again and again, and keeps what they share. It keeps coarse extinctions while the
/// OTF stays, and what a cutting surface leaves while the surface stays, each for two coarsenesses, because pictures
/// while the hand moves and pictures at rest alternate. If only the key light changes, it keeps the light around the
/// viewer. Only one thread at a time may use it.
///
/// The light of a place is a mean over a fixed set of directions. The key light's directions lie within its half-angle.
/// Those around the viewer lie in the hemisphere before the viewer and count by the cosine. Light is swept along each
/// direction from slice to slice of the grid. The OTF's opacities attenuate it per unit of length, by
/// LightScene::attenuation. No data, the outside of the volume and what is cut away attenuate nothing.
class LightSweep {
public:
    explicit LightSweep(std::shared_ptr<const Volume> volume);
    ~LightSweep();
    LightSweep(LightSweep&&) noexcept;
    LightSweep& operator=(LightSweep&&) noexcept;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// Follows another cut of the same scan. The cuts differ in the marked rows only (rowsMaskedOtherwise()), and only
    /// these are computed anew.
    void setCut(std::shared_ptr<const Volume> volume, const RowMarks& masked);
    /// The result is empty only if progress.cancel was raised, which is polled in every slice. The work runs in the
    /// calling thread's oneTBB arena. The bytes are the same for any number of threads. Throws std::invalid_argument if
    /// a member of the scene is out of range, or if otf.gradients have another grid or scale than the volume and the
    /// OTF.
    [[nodiscard]] std::optional<LightVolume> lightVolume(const LightOtf& otf, const LightScene& scene,
                                                         const Progress& progress = {});

private:
    class Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
