// All that a picture depends on, apart from the volume and its opacity curve.
#pragma once

#include <optional>
#include <vector>

#include "processing/picture/camera.h"
#include "processing/picture/colour_map.h"
#include "processing/picture/render_mode.h"
#include "processing/picture/shading.h"
#include "processing/sampling/interpolation.h"
#include "processing/viewpoint/cut_surface.h"
#include "processing/viewpoint/oriented_box.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// The picture shows only what lies between two corners; grid mm.
struct RenderBox {
    Vec3 low, high;
    friend bool operator==(const RenderBox&, const RenderBox&) = default;
};

/// The picture shows only what lies on the side of the normal; grid mm.
struct ClippingPlane {
    Vec3 point;
    Vec3 normal{0, 0, 1};  ///< any length above 0
    friend bool operator==(const ClippingPlane&, const ClippingPlane&) = default;
};

/// Another picture to mix into one of the direct mode, along the same rays: share parts of it with 1 - share parts of
/// the direct one. Colours are premultiplied by alpha. Depths are the direct picture's.
struct ModeMixing {
    double share = 0.0;  ///< [0, 1]; at 0 nothing is mixed
    RenderMode mode = RenderMode::maximum;
    friend bool operator==(const ModeMixing&, const ModeMixing&) = default;
};

struct RayCastSettings {
    int width = 512, height = 512;  ///< pixels; rays pass through pixel centres
    Camera camera;
    std::optional<CuttingFace> front;  ///< nothing is shown before it; fixed to the volume, not to the camera
    double step = 1.0;                 ///< units (smallest spacing) between samples, > 0
    Interpolation interpolation = Interpolation::trilinear;
    RenderMode mode = RenderMode::direct;
    ModeMixing mixing{};  ///< direct mode only
    ColourMap colourMap = ColourMap::sepia;
    double brightness = 1.0;  ///< a factor on the picture's colours, above 0; no colour becomes brighter than white
    std::optional<Shading> shading;  ///< direct mode only; without it, no gradient is computed
    int lightCoarseness = 2;         ///< [1, 16]: of the light in a volume of usual size, see lightSceneOf()
    std::optional<DepthColouring> depthColouring;  ///< direct mode only
    std::optional<RenderBox> box;
    std::vector<ClippingPlane> clippingPlanes;
    std::optional<CutSurface> cutSurface;  ///< nothing is shown before it; fixed to the volume, not to the camera
    double terminationTransmittance = 1.0 / 512;  ///< a ray ends below this; the error is at most this share of white
    /// Levels of 255, >= 0. Above 0, rays go through every fourth or second column and row first, in direct mode
    /// without depths, if such rays lie a unit apart at most and no samples are kept. Pixels half-way between rays are
    /// interpolated if that seems to err by at most this (fillBetweenRays()), and then those half-way between them. 0
    /// casts every pixel.
    double pixelTolerance = 0.0;
    bool skipEmptySpace = true;  ///< skips regions that the curve makes transparent: the same picture, sooner
    bool findDepth = false;      ///< whether to fill Picture::depthMm
    friend bool operator==(const RayCastSettings&, const RayCastSettings&) = default;
};

/// The settings of the mixed-in picture by itself.
[[nodiscard]] inline RayCastSettings mixedIn(RayCastSettings settings) {
    settings.mode = settings.mixing.mode;
    settings.mixing = {};
    settings.shading.reset();
    settings.depthColouring.reset();
    settings.findDepth = false;
    settings.pixelTolerance = 0.0;
    return settings;
}

}  // namespace echolucent
