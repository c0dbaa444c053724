// Direct volume rendering on the CPU: Petersch 2005, eqs. 2 and 3 (Levoy's compositing), front to back, in float.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "processing/geometry.h"
#include "processing/opacity_curve.h"
#include "processing/progress.h"
#include "processing/view.h"
#include "processing/volume.h"

namespace echolucent {

enum class Projection { parallel, perspective };
enum class ColourMap { sepia, grey, ice };
enum class Interpolation { nearest, trilinear };

/// "sepia", "grey", "ice".
[[nodiscard]] std::string_view nameOf(ColourMap map);
[[nodiscard]] std::optional<ColourMap> colourMapFromName(std::string_view name);
/// Colour of a normalised intensity, each component in [0,1]: what a fully opaque, unshaded voxel shows.
[[nodiscard]] Vec3 colourOf(ColourMap map, double intensity);

/// A camera in grid mm.
struct Camera {
    Vec3 focalPoint{0, 0, 0};  ///< seen at the picture's centre
    ViewFrame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Projection projection = Projection::parallel;
    double heightMm = 1.0;           ///< parallel: height of the picture, mm
    double viewAngleDegrees = 30.0;  ///< perspective: full vertical angle
    double distanceMm = 1.0;         ///< perspective: from the eye to the focal point
};

/// The camera of the default picture: parallel, looking along the view, the whole volume in the picture with a small
/// margin for a picture of that width / height.
[[nodiscard]] Camera defaultCamera(const VolumeGeometry& geometry, const View& view, double aspect);

/// Gradient (Phong) shading by one directional light.
struct Shading {
    Vec3 towardsLight{-0.45, -0.55, -0.7};  ///< in camera axes (right, down, forward): upper left front of the viewer
    double ambient = 0.35;
    double diffuse = 0.75;
    double specular = 0.15;
    double specularPower = 20.0;
    friend bool operator==(const Shading&, const Shading&) = default;
};

struct RayCastSettings {
    int width = 512, height = 512;    ///< pixels; rays pass through pixel centres
    Camera camera;
    double nearPlaneDepthMm = 0.0;    ///< nothing before this distance along camera.frame.forward (see nearPlaneDepthMm())
    double step = 1.0;                ///< units (smallest spacing) between samples, > 0
    Interpolation interpolation = Interpolation::trilinear;
    ColourMap colourMap = ColourMap::sepia;
    std::optional<Shading> shading;   ///< none: no gradient is computed
    double terminationTransmittance = 1.0 / 512;  ///< a ray ends below this; the error is at most that share of white
};

/// Row-major from the top left, four floats a pixel: red, green, blue premultiplied by alpha, then alpha; all in [0,1].
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

/// Renders the volume. No-data voxels are transparent. Empty only where progress.cancel was raised (polled at least once
/// a row of tiles). Uses the calling thread's oneTBB arena; the same pixels for any number of threads.
/// Throws std::invalid_argument for a size, step or camera that makes no sense.
[[nodiscard]] std::optional<Picture> castRays(const Volume& volume, const OpacityCurve& curve,
                                              const RayCastSettings& settings, const Progress& progress = {});

/// The picture over an opaque background (eq. 3's c(r,0)) as 8-bit RGB, rows from the top, three bytes a pixel.
[[nodiscard]] std::vector<std::uint8_t> overBackground(const Picture& picture, const Vec3& background);

}  // namespace echolucent
