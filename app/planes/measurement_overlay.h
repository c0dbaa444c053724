// Measurements over the 3D view.
#pragma once

#include <vector>

#include "processing/scene/shown_measurement.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

namespace echolucent {

/// The marks, lines and words of measurements, drawn over the volume.
[[nodiscard]] Overlay overlayOf(const std::vector<ShownMeasurement>& shown);

/// Adds `more` to an overlay, drawn over it.
void append(Overlay& overlay, const Overlay& more);

/// The line from a marked place to the pointer.
[[nodiscard]] PictureLine rubberLine(const PicturePlace& from, const PicturePlace& to);

}  // namespace echolucent
