// Light on surfaces, and colours that change with depth.
#pragma once

#include "processing/picture/light_direction.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// How a picture uses a light volume (processing/light/light_volume.h). The defaults were chosen by looking
/// (docs/light.md).
struct ReachingLight {
    double shadow = 0.75;       ///< [0,1]: darkness of places without key light; 0 casts no shadow
    double occlusion = 0.75;    ///< [0,1]: darkness of places without light from around the viewer
    double translucency = 0.3;  ///< [0,1]: warmth of the key light in thin tissue, if it casts shadows
    friend bool operator==(const ReachingLight&, const ReachingLight&) = default;
};

/// Light in a picture: gradient (Blinn-Phong) shading by one directional key light. `reaching` says how the picture
/// uses a light volume: how much key light and how much light from around the viewer reaches a place.
///
/// The gradient is a central difference of trilinear samples in normalised intensity per unit. The surface's normal
/// points to the darker side. Speckle has gradients too, so weak gradients count for less. With m the gradient's
/// magnitude, w = m^2 / (m^2 + gradientFloor^2) is the share of a sample that is lit as a surface. The rest is lit
/// evenly. With n the normal, l towards the light, h halfway between light and eye, per channel:
///     factor = ambient o' + k' (diffuse (w max(0, (n.l + wrap) / (1 + wrap)) + (1 - w) evenLight)
///                               + w specular max(0, n.h)^specularPower)
///     lit    = (1 - u) factor + u
///     colour = min(1, colour * lit * (t + (1 - t) min(1, lit)))        t: shadowTintOf(colour map)
/// k' and o' come from the light that reaches the place (reachingFactor()), and are 1 without a light volume.
/// Highlights have the tissue's colour: white ones turn haze into grey fog. u is the share of a cut's face (CutFace),
/// which is unlit.
struct Shading {
    Vec3 towardsLight =
        echolucent::towardsLight(LightDirection{});  ///< any length above 0, in camera axes (right, down, forward)
    double ambient = 0.32;
    double diffuse = 0.85;
    double specular = 0.2;
    double specularPower = 20.0;
    double gradientReach = 2.0;             ///< units from the sample to each end of the difference, > 0
    double gradientFloor = 0.01;            ///< normalised intensity per unit, >= 0: about the gradient of speckle
    double wrap = 0.4;                      ///< [0,1]: how far light reaches around, 0 is Lambert's law
    double evenLight = 0.5;                 ///< [0,1]: the light where there is no surface
    double keyHalfAngleDegrees = 8.0;       ///< [0,45]: how soft the key light's shadows are; 0 has no penumbra
    ReachingLight reaching{0.0, 0.0, 0.0};  ///< no light volume, unless somebody asks

    /// Whether a light volume is asked for.
    [[nodiscard]] bool asksWhatReaches() const { return reaching.shadow > 0.0 || reaching.occlusion > 0.0; }
    friend bool operator==(const Shading&, const Shading&) = default;
};

/// The face of a cut. If the rendered part begins within tissue, the gradients there belong to speckle, not to
/// surfaces. A ray's share u of a cut's face is 1 at the ray's beginning. At the edges of the data it is at least
/// PresenceUse::border (1 up to presence 1/2, 0 from 7/8). A step of s units multiplies u by 1 / (1 + r s / 2) before
/// its sample and once more behind it. r = 1 / tissueDepth + (1 - min(1, a / tissueOpacity)) / fluidDepth, with a the
/// opacity of the step over its length s. So u falls slowly within tissue, at once in fluid.
struct CutFace {
    static constexpr double tissueOpacity = 1.0 / 16;  ///< per unit: any more opaque step is tissue
    static constexpr double tissueDepth = 16.0;        ///< units
    static constexpr double fluidDepth = 1.0;          ///< units
};

/// Colours change with depth along `forward`: each sample's colour is multiplied by a mix of the two tints. The mix is
/// linear from the foremost corner of the volume's box (or the near plane, whichever is farther) to the hindmost
/// corner.
struct DepthColouring {
    Vec3 nearTint{1.0, 0.94, 0.82};
    Vec3 farTint{0.42, 0.60, 1.0};
    friend bool operator==(const DepthColouring&, const DepthColouring&) = default;
};

}  // namespace echolucent
