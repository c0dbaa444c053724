// A viewpoint's cuts, as limits for the ray caster.
#pragma once

#include "processing/picture/ray_cast_settings.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// The settings with the viewpoint's limits (flat front, cut surface, box) in place of their own. A box along the
/// grid's axes becomes RayCastSettings::box, another one becomes clipping planes. Faces that cut nothing off the volume
/// are left out (facesThatCut()).
[[nodiscard]] RayCastSettings limitedTo(const Viewpoint& view, const VolumeGeometry& geometry,
                                        RayCastSettings settings);

/// The least depth along the camera's view at which something of a volume's box lies behind the settings' front, mm
/// from the grid origin. Depths are coloured from here on.
[[nodiscard]] double nearestDepthMm(const RayCastSettings& settings, const VolumeGeometry& geometry);

}  // namespace echolucent
