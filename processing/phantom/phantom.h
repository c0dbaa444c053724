// Simulated 3D ultrasound volumes with known surfaces (Petersch 2005, section 5; the conditions of method.md).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

enum class PhantomScene {
    shapes,  ///< the paper's: an ellipsoid, a cylinder, spheres behind a window of fluid in tissue
    fetus,   ///< a fetus in profile in a fluid sac, with limbs, cord, placenta, uterine wall
    empty,   ///< tissue without any fluid: no interface to find
};
[[nodiscard]] std::optional<PhantomScene> phantomSceneFromName(std::string_view name);
[[nodiscard]] std::string_view nameOf(PhantomScene scene);

/// What the anatomy of a phantom is made of.
enum class PhantomMaterial { fluid, tissue, object };
[[nodiscard]] std::string_view nameOf(PhantomMaterial material);

/// Intensities are 0..255 whatever the number of bits stored. A unit is the smallest spacing. The scene is laid out
/// relative to the volume's extent in mm (one scale for all axes), so that any size and spacing show the same anatomy.
struct PhantomConfig {
    PhantomScene scene = PhantomScene::fetus;
    std::array<std::int64_t, 3> size{199, 197, 199};
    Vec3 spacing{0.5, 0.5, 0.5};                   ///< mm
    double fluid = 14, tissue = 85, object = 170;  ///< mean echo, [0,255]
    double ramp = 4;                               ///< width of a boundary, units
    double gainVariation = 0.15;    ///< slow change of gain across the volume: between 1 - this and 1 + this
    double speckle = 0.5;           ///< s of 1 + s (R - 1), R Rayleigh of unit mean; [0,1]
    double speckleSize = 2;         ///< FWHM of the smoothing of the complex noise, voxels; 0: uncorrelated
    double attenuation = 0;         ///< per unit along +z
    double shadow = 0;              ///< per unit of object passed along +z
    double specular = 0;            ///< brightening of surfaces that face the probe, share, times the cosine
    double logCompressDecibel = 0;  ///< dynamic range of logarithmic compression; 0: none
    bool frontWall = false;         ///< tissue in front of the fluid, across the whole field, 20 to 25 units thick
                                    ///< (at most a fifth of the depth)
    int bits = 8;                   ///< 8, 12 or 16
    std::uint64_t seed = 1;
    double phase = 0;  ///< of the movement (an arm, the heart), in turns [0,1)
    friend bool operator==(const PhantomConfig&, const PhantomConfig&) = default;
};

/// The usual config of a scene: the base condition; a fetus gets less speckle, attenuation, shadow and a glint on
/// surfaces that face the probe. It is what is shown where no file is given.
[[nodiscard]] PhantomConfig defaultPhantom(PhantomScene scene);

/// One of the conditions of the studies behind the method, by name.
struct NamedPhantom {
    std::string name;
    PhantomConfig config;
};

/// Each takes scene, size, spacing, seed and whatever else is not part of the condition from `base`.
/// "base", "ramp2", "little_speckle", "attenuation_shadow", "specular".
[[nodiscard]] std::vector<NamedPhantom> ordinaryConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));
/// "hard_full_speckle", "hard_uncorrelated", "hard_ramp8", "hard_low_contrast", "hard_log_compressed".
[[nodiscard]] std::vector<NamedPhantom> hardConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));
/// "front_wall".
[[nodiscard]] std::vector<NamedPhantom> frontWallConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));
/// "empty".
[[nodiscard]] std::vector<NamedPhantom> emptyConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));

/// A part of the scene's anatomy, in words and numbers for the truth file.
struct PhantomPrimitive {
    std::string name;      ///< "head", "window of fluid"
    std::string kind;      ///< "ellipsoid", "round cone", "round box", "cylinder" or "wavy plane"
    std::string material;  ///< "fluid", "tissue" or "object"
    bool carves = false;   ///< taken away from the body it belongs to, instead of added
    double seamMm = 0;     ///< width of the rounded seam with the primitives before it in its body
    double echo = 0;       ///< mean echo, 0..255
    /// In grid mm. Ellipsoid: centre (3), radii (3), axes (9, row-major, columns are the axes). Round cone: ends (3 +
    /// 3), radii at the ends (2). Round box: centre (3), half sizes (3), rounding, axes (9). Cylinder: ends (3 + 3),
    /// radius, rounding. Wavy plane: point (3), outward normal (3), depth and length of the waves (2).
    std::vector<double> parameters;
};

struct PhantomScenery;

/// The scene's materials in closed form. Scenes are laid out on a +z beam. Cheap to copy.
class PhantomTruth {
public:
    /// Throws std::invalid_argument where the config makes no sense (see makePhantom()).
    explicit PhantomTruth(const PhantomConfig& config);
    [[nodiscard]] std::vector<PhantomPrimitive> primitives() const;
    /// Noise-free echo (0..255) at a position in grid mm: ramps, no gain variation, specular, attenuation or speckle.
    [[nodiscard]] double echoAt(const Vec3& gridMm) const;
    /// Distance in units from the ray's entry into the volume's box to the first transition from at least 8 units of
    /// fluid to tissue or object (the sharp boundary, the middle of the ramp); none: no such interface on this ray.
    /// originMm: any point of the ray's line; direction of any length above 0. nearPlaneDepthMm: the ray enters no
    /// earlier than the plane direction . p = nearPlaneDepthMm (see nearPlaneDepthMm() in view.h).
    [[nodiscard]] std::optional<double> firstInterface(
        const Vec3& originMm, const Vec3& direction,
        double nearPlaneDepthMm = -std::numeric_limits<double>::infinity()) const;
    /// The same transition as a point in grid mm.
    [[nodiscard]] std::optional<Vec3> firstInterfacePoint(
        const Vec3& originMm, const Vec3& direction,
        double nearPlaneDepthMm = -std::numeric_limits<double>::infinity()) const;
    /// The sharp material at a position in grid mm; on a boundary that of the body it bounds.
    [[nodiscard]] PhantomMaterial materialAt(const Vec3& gridMm) const;
    /// Signed distance (mm) to the fluid, negative within it: the sharp materials.
    [[nodiscard]] double fluidDistance(const Vec3& gridMm) const;

private:
    PhantomConfig m_config;
    std::shared_ptr<const PhantomScenery> m_scenery;

    struct Transition {
        double entry, surface;  ///< mm along the unit direction from the ray's origin
    };
    [[nodiscard]] std::optional<Transition> firstTransition(const Vec3& originMm, const Vec3& forward,
                                                            double nearPlaneDepthMm) const;
};

/// Builds the volume: the same bits for the same config on any number of threads. Empty only where cancelled.
/// White level: 255, 4095 or 65535. Throws std::invalid_argument where the config makes no sense: a size below 1, a
/// spacing not above 0, bits other than 8, 12, 16, a negative length or share.
[[nodiscard]] std::optional<Volume> makePhantom(const PhantomConfig& config, const Progress& progress = {});

}  // namespace echolucent
