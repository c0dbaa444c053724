// All that a picture depends on beside the volume and its opacity curve.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "processing/picture/camera.h"
#include "processing/picture/colour_map.h"
#include "processing/picture/render_mode.h"
#include "processing/picture/shading.h"
#include "processing/sampling/interpolation.h"
#include "processing/viewpoint/cut_surface.h"
#include "processing/volume/geometry.h"

namespace echolucent {

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

/// Another picture that is mixed into one of the direct mode, along the same rays: share parts of it with 1 - share
/// parts of the direct one, colours premultiplied by alpha. Depths are those of the
/// direct one.
struct ModeMixing {
    double share = 0.0;  ///< [0, 1]; at 0 nothing is mixed
    RenderMode mode = RenderMode::maximum;
    friend bool operator==(const ModeMixing&, const ModeMixing&) = default;
};

struct RayCastSettings {
    int width = 512, height = 512;  ///< pixels; rays pass through pixel centres
    Camera camera;
    /// Nothing is shown before this distance, mm, from the grid origin along camera.frame.forward (nearPlaneDepthMm()).
    double nearPlaneDepthMm = -std::numeric_limits<double>::infinity();
    double step = 1.0;  ///< units (smallest spacing) between samples, > 0
    Interpolation interpolation = Interpolation::trilinear;
    RenderMode mode = RenderMode::direct;
    ModeMixing mixing{};  ///< direct mode only
    ColourMap colourMap = ColourMap::sepia;
    double brightness = 1.0;         ///< a factor on the picture's colours, above 0; none becomes brighter than white
    std::optional<Shading> shading;  ///< where it is not set, no gradient is computed; direct mode only
    int lightCoarseness = 2;         ///< of a usual volume's light, see lightSceneOf(); [1, 16]
    std::optional<DepthColouring> depthColouring;  ///< where it is not set, it costs nothing; direct mode only
    std::optional<RenderBox> box;
    std::vector<ClippingPlane> clippingPlanes;
    std::optional<CutSurface> cutSurface;  ///< nothing is shown before it; fixed to the volume, not to the camera
    double terminationTransmittance = 1.0 / 512;  ///< a ray ends below this; the error is at most that share of white
    bool skipEmptySpace = true;  ///< leaves out regions that the curve makes transparent: the same picture, sooner
    bool findDepth = false;      ///< Picture::depthMm is wanted
    friend bool operator==(const RayCastSettings&, const RayCastSettings&) = default;
};

/// The settings of the picture that is mixed in, by itself.
[[nodiscard]] inline RayCastSettings mixedIn(RayCastSettings settings) {
    settings.mode = settings.mixing.mode;
    settings.mixing = {};
    settings.shading.reset();
    settings.depthColouring.reset();
    settings.findDepth = false;
    return settings;
}

}  // namespace echolucent
