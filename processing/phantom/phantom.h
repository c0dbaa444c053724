// Simulated 3D ultrasound volumes with known surfaces (Petersch 2005, section 5).
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/phantom/phantom_config.h"
#include "processing/progress.h"
#include "processing/scan_conversion/conversion_grid.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A part of the scene's anatomy, for the truth file.
struct PhantomPrimitive {
    std::string name;      ///< "head", "window of fluid"
    std::string kind;      ///< "ellipsoid", "round cone", "round box", "cylinder" or "wavy plane"
    std::string material;  ///< "fluid", "tissue" or "object"
    bool carves = false;   ///< whether the primitive is carved out of its body, instead of added
    double seamMm = 0;     ///< width of the rounded seam with the primitives before it in its body
    double echo = 0;       ///< mean echo, 0..255
    /// In grid mm. Ellipsoid: centre (3), radii (3), axes (9, row-major, columns are the axes). Round cone: ends (3 +
    /// 3), radii at the ends (2). Round box: centre (3), half sizes (3), rounding, axes (9). Cylinder: ends (3 + 3),
    /// radius, rounding. Wavy plane: point (3), outward normal (3), depth and length of the waves (2).
    std::vector<double> parameters;
};

struct PhantomScenery;

/// The scene's materials in closed form. Scenes are laid out for a beam along +z. Copies are cheap.
class PhantomTruth {
public:
    /// Throws std::invalid_argument if the config makes no sense (see makePhantom()).
    explicit PhantomTruth(const PhantomConfig& config);
    [[nodiscard]] std::vector<PhantomPrimitive> primitives() const;
    /// Echo (0..255) at a position in grid mm, with ramps, but without speckle, gain variation, specular brightening,
    /// shadow, attenuation and compression.
    [[nodiscard]] double echoAt(const Vec3& gridMm) const;
    /// Distance in units from the ray's entry into the volume's box to the first interface, if any. That is the first
    /// transition from at least 8 units of fluid to tissue or object (the sharp boundary, the middle of the ramp).
    /// originMm: any point of the ray's line. direction: any length above 0. nearPlaneDepthMm: the ray enters no
    /// earlier than the plane direction . p = nearPlaneDepthMm (see nearPlaneDepthMm() in viewpoint.h).
    [[nodiscard]] std::optional<double> firstInterface(
        const Vec3& originMm, const Vec3& direction,
        double nearPlaneDepthMm = -std::numeric_limits<double>::infinity()) const;
    /// The transition of firstInterface() as a point in grid mm.
    [[nodiscard]] std::optional<Vec3> firstInterfacePoint(
        const Vec3& originMm, const Vec3& direction,
        double nearPlaneDepthMm = -std::numeric_limits<double>::infinity()) const;
    /// The sharp material at a position in grid mm. A point on a body's boundary belongs to the body.
    [[nodiscard]] PhantomMaterial materialAt(const Vec3& gridMm) const;
    /// Signed distance (mm) to the fluid with sharp boundaries, negative in the fluid.
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

/// Builds the volume, with the same bits for the same config on any number of threads. Empty only if cancelled. The
/// white level is 255, 4095 or 65535, by the config's bits. Throws std::invalid_argument if the config makes no sense:
/// a size below 1, a spacing not above 0, bits other than 8, 12, 16, a negative length or share, speckle larger than 64
/// voxels.
[[nodiscard]] std::optional<Volume> makePhantom(const PhantomConfig& config, const Progress& progress = {});

/// The scene's config on the grid of a converted polar volume. The anatomy is laid out in that grid, so the config's
/// truth is that of the converted volume.
[[nodiscard]] PhantomConfig configOnGrid(PhantomConfig config, const ConversionGrid& grid);
/// The scene of a config from configOnGrid(), seen along the beams of `polar`, in the index order of `polar`.
/// Attenuation, shadow and glints follow the beams. Speckle has its size in samples, lines and planes. Empty only if
/// cancelled. Throws as makePhantom() does.
[[nodiscard]] std::optional<Voxels> makePolarPhantom(const PhantomConfig& config, const PolarGeometry& polar,
                                                     const ConversionGrid& grid, const Progress& progress = {});

}  // namespace echolucent
