// The view from the probe, where a file says where the probe was.
#pragma once

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/stated_probe.h"

namespace echolucent {

/// The view along the mean direction of sound with the probe's own "down" at the bottom of the picture, relative to the
/// grid axis that lies nearest to that direction. Angles that are less than a millionth of a degree are 0.
[[nodiscard]] Viewpoint viewFromProbe(const StatedProbe& probe);

}  // namespace echolucent
