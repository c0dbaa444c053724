// Simulated 3D ultrasound volumes with known surfaces (Petersch 2005, section 5; the conditions of method.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/geometry.h"
#include "processing/progress.h"
#include "processing/volume.h"

namespace echolucent {

enum class PhantomScene {
    shapes,  ///< the paper's: an ellipsoid, a cylinder, spheres behind a window of fluid in tissue
    fetus,   ///< a fetus in profile in a fluid sac, with limbs, cord, placenta, uterine wall
    empty,   ///< tissue without any fluid: no interface to find
};
[[nodiscard]] std::optional<PhantomScene> phantomSceneFromName(std::string_view name);
[[nodiscard]] std::string_view nameOf(PhantomScene scene);

/// Intensities are 0..255 whatever the number of bits stored; lengths in voxels unless mm is said.
struct PhantomConfig {
    PhantomScene scene = PhantomScene::fetus;
    std::array<std::int64_t, 3> size{199, 197, 199};
    Vec3 spacing{0.5, 0.5, 0.5};       ///< mm
    double fluid = 14, tissue = 85, object = 170;  ///< mean echo, [0,255]
    double ramp = 4;                   ///< width of a boundary, units
    double gainVariation = 0.15;       ///< slow change of gain across the volume, share
    double speckle = 0.5;              ///< s of 1 + s (R - 1), R Rayleigh of unit mean; [0,1]
    double speckleSize = 2;            ///< FWHM of the smoothing of the complex noise, voxels; 0: uncorrelated
    double attenuation = 0;            ///< per unit along +z
    double shadow = 0;                 ///< per unit of object passed along +z
    double specular = 0;               ///< brightening of surfaces that face the probe, share
    double logCompressDecibel = 0;     ///< dynamic range of logarithmic compression; 0: none
    bool frontWall = false;            ///< tissue in front of the fluid, across the whole field
    int bits = 8;                      ///< 8, 12 or 16
    std::uint64_t seed = 1;
    double phase = 0;                  ///< of the movement (an arm, the heart), in turns [0,1)
};

/// A part of the scene's anatomy, in words and numbers for the truth file.
struct PhantomPrimitive {
    std::string name;      ///< "head", "window of fluid"
    std::string kind;      ///< "ellipsoid", "capsule", "cylinder", "half space", ...
    std::string material;  ///< "fluid", "tissue" or "object"
    std::vector<double> parameters;  ///< centre, radii, ... in grid mm, as the kind says
};

/// The scene's materials in closed form. Scenes are laid out on a +z beam.
class PhantomTruth {
public:
    explicit PhantomTruth(const PhantomConfig& config);
    [[nodiscard]] std::vector<PhantomPrimitive> primitives() const;
    /// Noise-free echo (0..255) at a position in grid mm: ramps, no gain variation, attenuation or speckle.
    [[nodiscard]] double echoAt(const Vec3& gridMm) const;
    /// Distance in units from the ray's entry into the volume's box to the first transition from at least 8 units of
    /// fluid to tissue or object (the sharp boundary, the middle of the ramp); none: no such interface on this ray.
    [[nodiscard]] std::optional<double> firstInterface(const Vec3& originMm, const Vec3& direction) const;

private:
    PhantomConfig m_config;
};

/// Builds the volume: the same bits for the same config on any number of threads. Empty only where cancelled.
[[nodiscard]] std::optional<Volume> makePhantom(const PhantomConfig& config, const Progress& progress = {});

}  // namespace echolucent
