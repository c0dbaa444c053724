// What light that reaches a sample makes of its colour.
#pragma once

#include "processing/volume/geometry.h"

namespace echolucent {

/// How a picture uses a light volume (processing/light/light_volume.h). With k and o in [0,1] what reaches a sample of
/// the key light and of the light around the viewer, and w, ambient, diffuse, ... of Shading:
///     around = 1 - occlusion * (1 - o)
///     key[c] = 1 - shadow * (1 - k ^ (1 + translucency * warmth[c]))       c: red, green, blue
///     factor[c] = ambient * around + key[c] * (diffuse * (w * lambert + (1 - w) * evenLight) + w * specular *
///     highlight)
/// and the colour follows from factor[c] channel by channel as Shading says. With both strengths 0 that is Shading's
/// own factor.
struct ReachingLight {
    double shadow = 0.8;        ///< [0,1]: how dark it is where no key light reaches; 0 is no cast shadow
    double occlusion = 0.8;     ///< [0,1]: how dark it is where no light around the viewer reaches
    double translucency = 0.5;  ///< [0,1]: how warm the key light becomes on its way through tissue
    friend bool operator==(const ReachingLight&, const ReachingLight&) = default;
};

/// Light loses its blue first on its way through tissue: exponents' changes for red, green, blue.
inline const Vec3 warmth{-0.5, 0.0, 0.3};

}  // namespace echolucent
