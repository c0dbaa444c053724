// The scene of a simulated scan and its disturbances (Petersch 2005, section 5; docs/cli-phantom.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

enum class PhantomScene {
    shapes,  ///< the paper's: an ellipsoid, a cylinder, spheres behind a window of fluid in tissue
    fetus,   ///< a fetus in profile in a fluid sac, with limbs, cord, placenta, uterine wall
    empty,   ///< tissue without any fluid: no interface to find
};
[[nodiscard]] std::optional<PhantomScene> phantomSceneFromName(std::string_view name);
[[nodiscard]] std::string_view nameOf(PhantomScene scene);

/// A material of a phantom's anatomy.
enum class PhantomMaterial { fluid, tissue, object };
[[nodiscard]] std::string_view nameOf(PhantomMaterial material);

/// Intensities are 0..255 for any number of stored bits. A unit is the smallest spacing. The scene is laid out relative
/// to the volume's extent in mm (one scale for all axes), so any size and spacing show the same anatomy.
struct PhantomConfig {
    PhantomScene scene = PhantomScene::fetus;
    std::array<std::int64_t, 3> size{199, 197, 199};
    Vec3 spacing{0.5, 0.5, 0.5};                   ///< mm
    double fluid = 14, tissue = 85, object = 170;  ///< mean echo, [0,255]
    double ramp = 4;                               ///< width of a boundary, units
    double gainVariation = 0.15;  ///< slow change of gain across the volume: between 1 - this and 1 + this
    double speckle = 0.5;         ///< s of 1 + s (R - 1), R Rayleigh of unit mean; [0,1]
    double speckleSize = 2;  ///< FWHM of the smoothing of the complex noise, voxels; if 0, the noise is uncorrelated
    double attenuation = 0;  ///< echo falls by exp(-attenuation) per unit along the beam (+z)
    double shadow = 0;       ///< echo falls by exp(-shadow) per unit of object passed along the beam
    double specular = 0;     ///< brightening of surfaces: this share times the cosine between normal and beam
    double logCompressDecibel = 0;  ///< dynamic range of logarithmic compression; if 0, there is none
    bool frontWall = false;  ///< tissue before the fluid, across the whole field, 20 to 25 units thick (in the mean at
                             ///< most a fifth of the depth); not in the empty scene
    int bits = 8;            ///< 8, 12 or 16
    std::uint64_t seed = 1;
    double phase = 0;  ///< of the fetus' movement (an arm, the heart), in turns [0,1)
    friend bool operator==(const PhantomConfig&, const PhantomConfig&) = default;
};

/// The usual config of a scene: the base condition. A fetus gets less speckle, and attenuation, shadow and glints on
/// surfaces that face the probe. If no file is given, the program shows a fetus with this config.
[[nodiscard]] PhantomConfig defaultPhantom(PhantomScene scene);

}  // namespace echolucent
