// The picture of a view of a document, by itself: what a window shows of it at rest, without a window.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "processing/document/document.h"
#include "processing/opacity_curve.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How a view is cast at its look's own step. The camera is that of the shown pose, fitted to a data box; the limits
/// are the view's cut and box.
[[nodiscard]] RayCastSettings castSettingsOf(const Document& document, int view, const VolumeGeometry& geometry,
                                             const DataBox& box, int width, int height);

/// What a view shows.
struct ViewPicture {
    Picture picture;
    RayCastSettings cast;                  ///< what it was cast with
    OpacityCurve curve;                    ///< that it is rendered with
    std::shared_ptr<const Volume> voxels;  ///< quiet where speckle is reduced, and cut by the strokes
    std::string message;                   ///< what the adaptive OTF has to say; else empty
};

/// The converged picture (processing/picture/converged.h) of a view. `scan`: the phase that the view shows, as it was
/// read. The strokes cut raw and quiet voxels; the adaptive curve is computed from raw ones along otfViewpointOf(), in
/// direct mode and where the view is rendered with it. The result is empty only where progress.cancel was raised.
[[nodiscard]] std::optional<ViewPicture> viewPicture(const Document& document, int view, const Volume& scan, int width,
                                                     int height, const Progress& progress = {});

}  // namespace echolucent
