// What a viewpoint cuts off, as the ray caster is told it.
#pragma once

#include "processing/picture/ray_cast_settings.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// The settings with the limits of a viewpoint, near plane, cut surface and box, in place of the limits that they held.
/// A box along the grid's axes becomes RayCastSettings::box, another one clipping planes; faces that cut nothing off
/// the volume are left out (facesThatCut()). The camera must look along the view.
[[nodiscard]] RayCastSettings limitedTo(const Viewpoint& view, const VolumeGeometry& geometry,
                                        RayCastSettings settings);

}  // namespace echolucent
