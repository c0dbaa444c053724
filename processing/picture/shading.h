// Light on surfaces, and colours that change with depth.
#pragma once

#include "processing/picture/light_direction.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// Gradient (Blinn-Phong) shading by one directional light. The gradient is a central difference of trilinear samples
/// in normalised intensity per unit; the surface's normal points to the darker side. Speckle has gradients too, so a
/// weak gradient counts for less: with m its magnitude, a sample is lit as a surface with the share
/// w = m^2 / (m^2 + gradientFloor^2) and evenly with the rest. Samples whose gradient touches no data have w = 0. With
/// n the normal, l towards the light, h halfway between light and eye, per channel:
///     factor = ambient + diffuse * (w * max(0, (n.l + wrap) / (1 + wrap)) + (1 - w) * evenLight)
///              + w * specular * max(0, n.h)^specularPower
///     colour = min(1, colour * factor * (t + (1 - t) * min(1, factor)))        t: shadowTintOf(colour map)
/// Highlights have the colour of what they lie on: white ones turn haze into grey fog.
struct Shading {
    Vec3 towardsLight =
        echolucent::towardsLight(LightDirection{});  ///< any length above 0, in camera axes (right, down, forward)
    double ambient = 0.32;
    double diffuse = 0.85;
    double specular = 0.2;
    double specularPower = 20.0;
    double gradientReach = 2.0;   ///< units from the sample to each sample of the difference, > 0
    double gradientFloor = 0.01;  ///< normalised intensity per unit, >= 0: about the gradient of speckle
    double wrap = 0.4;            ///< [0,1]: how far light reaches around, 0 is Lambert's law
    double evenLight = 0.5;       ///< [0,1]: the light where there is no surface
    friend bool operator==(const Shading&, const Shading&) = default;
};

/// Colours change with depth along `forward`: a sample's colour is multiplied by a mix of the two tints, linear from
/// the foremost corner of the volume's box (or the near plane, whichever is farther) to its hindmost corner.
struct DepthColouring {
    Vec3 nearTint{1.0, 0.94, 0.82};
    Vec3 farTint{0.42, 0.60, 1.0};
    friend bool operator==(const DepthColouring&, const DepthColouring&) = default;
};

}  // namespace echolucent
