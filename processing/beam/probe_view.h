// The view from the probe, if a file says where the probe was.
#pragma once

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/stated_probe.h"

namespace echolucent {

/// The view along the mean direction of sound, relative to the grid axis nearest to it. The probe's own "down" points
/// to the bottom of the picture. Angles below a millionth of a degree become 0.
[[nodiscard]] Viewpoint viewFromProbe(const StatedProbe& probe);

}  // namespace echolucent
