// How much light reaches each place of a volume through the opacities before it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How much light reaches places of a grid over a volume. Between places it is read trilinearly, beyond the outermost
/// places at the outermost.
struct LightVolume {
    std::array<int, 3> size{};  ///< places along x, y, z
    Vec3 firstMm;               ///< grid mm of place (0,0,0)
    Vec3 spacingMm;             ///< mm between places along x, y, z
    /// Two bytes a place, x fastest: first how much of the key light, then how much of the light around the viewer
    /// reaches it; 255 is all of it.
    std::vector<std::uint8_t> reaching;
    friend bool operator==(const LightVolume&, const LightVolume&) = default;
};

/// What is rendered of a volume, as RayCastSettings says it: what is cut away attenuates no light.
struct RenderedPart {
    Vec3 forward{0, 0, 1};  ///< grid mm, unit: the direction along which the near plane's depth is counted
    double nearPlaneDepthMm = -std::numeric_limits<double>::infinity();  ///< from the grid origin along `forward`
    std::optional<RenderBox> box;
    std::vector<ClippingPlane> clippingPlanes;
    friend bool operator==(const RenderedPart&, const RenderedPart&) = default;
};

/// What a light volume depends on beside voxels and curve.
struct LightScene {
    Vec3 towardsKey{0, 0, -1};         ///< grid mm, any length above 0
    Vec3 towardsViewer{0, 0, -1};      ///< grid mm, any length above 0
    double keyHalfAngleDegrees = 8.0;  ///< [0, 45]: half the angle under which the key light is seen; 0 has no penumbra
    RenderedPart rendered;
    /// [1, 16]: units (smallest spacing) from place to place, as whole voxels, at least one, along each axis: 2 or 3 at
    /// rest, 4 while the hand moves.
    int coarseness = 2;
    friend bool operator==(const LightScene&, const LightScene&) = default;
};

/// The scene of a picture: its light (settings.shading, or the default light where it is not set), its viewer and what
/// it renders. All beside the two numbers of LightScene is taken from the settings.
[[nodiscard]] LightScene lightSceneOf(const RayCastSettings& settings);

/// Makes light volumes of one volume again and again, and keeps what they have in common: coarse intensities and, where
/// only the key light changed, the light around the viewer. Only one thread at a time may use it.
///
/// A place's light is the mean over a fixed set of directions: for the key light directions within its half-angle, for
/// the light around the viewer directions of the hemisphere before him, by the cosine. Along each the light is swept
/// from slice to slice of the grid. Opacities are the curve's, per unit of length; no data and what lies outside the
/// volume attenuate nothing, nor does what is cut away.
class LightSweep {
public:
    explicit LightSweep(std::shared_ptr<const Volume> volume);
    ~LightSweep();
    LightSweep(LightSweep&&) noexcept;
    LightSweep& operator=(LightSweep&&) noexcept;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// The result is empty only where progress.cancel was raised (it is polled in every slice). The work is done in the
    /// calling thread's oneTBB arena, and the bytes are the same for any number of threads. Throws
    /// std::invalid_argument for a scene out of range.
    [[nodiscard]] std::optional<LightVolume> lightVolume(const OpacityCurve& curve, const LightScene& scene,
                                                         const Progress& progress = {});

private:
    class Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
