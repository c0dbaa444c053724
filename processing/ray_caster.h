// Direct volume rendering on the CPU: Petersch 2005, eqs. 2 and 3 (Levoy's compositing), front to back, in float.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/progress.h"
#include "processing/viewpoint.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

enum class Projection { parallel, perspective };
enum class ColourMap { sepia, grey, ice };
enum class Interpolation { nearest, trilinear };

/// "sepia", "grey", "ice".
[[nodiscard]] std::string_view nameOf(ColourMap map);
[[nodiscard]] std::optional<ColourMap> colourMapFromName(std::string_view name);
/// Colour of a normalised intensity, each component in [0,1]: what a fully opaque, unshaded voxel shows.
[[nodiscard]] Vec3 colourOf(ColourMap map, double intensity);

/// The tint of a shadow (t of Shading): bright tissue in shadow takes the map's dark hue, not grey.
[[nodiscard]] Vec3 shadowTintOf(ColourMap map);

/// A camera in grid mm.
struct Camera {
    Vec3 focalPoint{0, 0, 0};  ///< seen at the picture's centre
    ViewFrame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Projection projection = Projection::parallel;
    double heightMm = 1.0;           ///< parallel: height of the picture, mm
    double viewAngleDegrees = 30.0;  ///< perspective: full vertical angle
    double distanceMm = 1.0;         ///< perspective: from the eye to the focal point
    friend bool operator==(const Camera& a, const Camera& b) = default;
};

/// The camera of the default picture: parallel, looking along the view, the whole box in the picture with 4 % of its
/// extent to spare, for a picture of that width / height (> 0). Its perspective values are set too: switching the
/// projection keeps the whole box in the picture.
[[nodiscard]] Camera defaultCamera(const VolumeGeometry& geometry, const Viewpoint& view, double aspect);

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
    Vec3 towardsLight{-0.45, -0.55, -0.7};  ///< in camera axes (right, down, forward): upper left front of the viewer
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

/// What a ray shows of its samples.
enum class RenderMode {
    direct,   ///< direct volume rendering: eqs. 2 and 3
    maximum,  ///< the colour of the largest intensity on the ray; the curve plays no part here and below
    minimum,  ///< of the smallest
    mean,     ///< of the mean: an x-ray
};

/// "direct", "maximum", "minimum", "mean".
[[nodiscard]] std::string_view nameOf(RenderMode mode);
[[nodiscard]] std::optional<RenderMode> renderModeFromName(std::string_view name);

/// Colours change with depth along `forward`: a sample's colour is multiplied by a mix of the two tints, linear from
/// the foremost corner of the volume's box (or the near plane, whichever is farther) to its hindmost corner.
struct DepthColouring {
    Vec3 nearTint{1.0, 0.94, 0.82};
    Vec3 farTint{0.42, 0.60, 1.0};
    friend bool operator==(const DepthColouring&, const DepthColouring&) = default;
};

/// Only what lies between two corners is rendered; grid mm.
struct RenderBox {
    Vec3 low, high;
    friend bool operator==(const RenderBox&, const RenderBox&) = default;
};

/// Only what lies on the side that the normal points to is rendered; grid mm.
struct ClippingPlane {
    Vec3 point;
    Vec3 normal{0, 0, 1};  ///< any length above 0
    friend bool operator==(const ClippingPlane&, const ClippingPlane&) = default;
};

/// Where something opaque stands in each pixel: depth along camera.frame.forward from the grid origin, mm; infinity:
/// nothing. Row-major from the top left. A map of another size than the picture's is read at the nearest place.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> depthMm;
};

struct RayCastSettings {
    int width = 512, height = 512;  ///< pixels; rays pass through pixel centres
    Camera camera;
    /// Nothing before this distance from the grid origin along camera.frame.forward (see nearPlaneDepthMm()).
    double nearPlaneDepthMm = -std::numeric_limits<double>::infinity();
    double step = 1.0;  ///< units (smallest spacing) between samples, > 0
    Interpolation interpolation = Interpolation::trilinear;
    RenderMode mode = RenderMode::direct;
    ColourMap colourMap = ColourMap::sepia;
    std::optional<Shading> shading;                ///< none: no gradient is computed; direct mode only
    std::optional<DepthColouring> depthColouring;  ///< none: costs nothing; direct mode only
    std::optional<RenderBox> box;
    std::vector<ClippingPlane> clippingPlanes;
    std::shared_ptr<const DepthMap> opaqueDepth;  ///< null: rays end at the volume's box only
    double terminationTransmittance = 1.0 / 512;  ///< a ray ends below this; the error is at most that share of white
    bool skipEmptySpace = true;  ///< leaves out regions that the curve makes transparent: the same picture, sooner
    /// Opacity of a step from all intensities between its two ends, not from one in its middle: thin ranges of the
    /// curve are not stepped over. Direct mode, unshaded.
    bool preIntegrated = false;
    /// Each ray starts at a place of its own within its first step, the same run after run: rings become noise.
    bool jittered = false;
    bool findDepth = false;  ///< Picture::depthMm is wanted
    friend bool operator==(const RayCastSettings&, const RayCastSettings&) = default;
};

/// Row-major from the top left, four floats a pixel: red, green, blue premultiplied by alpha, then alpha; all in [0,1].
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgba;
    /// Where findDepth was asked for: depth along camera.frame.forward from the grid origin, mm, of the sample at which
    /// the accumulated opacity reaches one half (maximum and minimum: of the sample shown; mean: of the first);
    /// infinity where none does. Else empty.
    std::vector<float> depthMm{};
};

/// Renders the volume. Steps of parallel rays lie between planes across the view, counted from the near plane or the
/// box's foremost corner, whichever is farther; those of perspective rays between distances from the eye, counted from
/// the depth of that plane. Each is sampled in its middle. Where what is rendered begins or ends within a step, what is
/// left of the step is sampled in its own middle and counts with its length, so that the picture converges with the
/// square of the step also at the faces of the box.
///
/// Trilinear samples are means over the data voxels around them; a sample with less than half its weight on data is
/// transparent. Positions are exact to 1/8192 voxel. Bytes are interpolated with shares of 15 bits, along y of 7, as if
/// a sample lay up to 1/128 voxel beside its place (a tenth of a level where neighbours differ by 12); other voxels in
/// float. Opacities come from one table of 2041 intensities, linear between (its nodes are the 8-bit values and seven
/// between each two): exact to 2e-7 for x^2 of scale 1, to 1/2040 in intensity at a step of a curve; those of bytes of
/// a white level from 128 on from the nearest of 16 intensities between two values: to 1/8160 in intensity. Opacity is
/// gathered in float over at most 64 samples and then in double, as opacity, not as transmittance: exact to 1e-5 over 2
/// * 10^5 samples. A ray ends at a multiple of 8 steps. Lighting is left out (w = 0) where a step adds less than min(1,
/// step) / 128 to its pixel's opacity. Memory: twice the volume's, and two bytes a voxel more where voxels lack data.
///
/// Empty only where progress.cancel was raised (polled once a tile of 32 x 32 pixels). Uses the calling thread's oneTBB
/// arena; the same pixels for any number of threads. Throws std::invalid_argument for settings that make no sense.
[[nodiscard]] std::optional<Picture> castRays(const Volume& volume, const OpacityCurve& curve,
                                              const RayCastSettings& settings, const Progress& progress = {});

/// Casts rays through one volume again and again, and keeps what pictures have in common: the voxels in the order the
/// kernel reads them, where they are empty under the curve, and, for an edit of the curve under a fixed camera, the
/// samples themselves. Pictures are those of castRays(), from kept samples to half an 8-bit level (RMSE 0.02): 16 bits
/// are kept of each. One thread at a time.
class RayCaster {
public:
    explicit RayCaster(std::shared_ptr<const Volume> volume);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// As castRays(). Where all but the curve and the colour map is as in the call before, the samples of that view are
    /// kept (see sampleMemoryLimit) and from then on only classified and composited anew.
    [[nodiscard]] std::optional<Picture> cast(const OpacityCurve& curve, const RayCastSettings& settings,
                                              const Progress& progress = {});

    /// Bytes that the samples of one view may take; above it nothing is kept. 2 bytes a sample.
    static constexpr std::size_t sampleMemoryLimit = std::size_t{512} << 20;
    /// Bytes of kept samples now; 0 where none are kept.
    [[nodiscard]] std::size_t keptSampleBytes() const;

private:
    class Parts;
    std::unique_ptr<Parts> m_parts;
};

/// The picture over an opaque background (eq. 3's c(r,0)) as 8-bit RGB, rows from the top, three bytes a pixel.
[[nodiscard]] std::vector<std::uint8_t> overBackground(const Picture& picture, const Vec3& background);

}  // namespace echolucent
