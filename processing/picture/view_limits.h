// A viewpoint's cuts, as limits for the ray caster.
#pragma once

#include "processing/picture/ray_cast_settings.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// The settings with the viewpoint's limits (near plane, cut surface, box) in place of their own. A box along the
/// grid's axes becomes RayCastSettings::box, another one becomes clipping planes. Faces that cut nothing off the volume
/// are left out (facesThatCut()). The camera must look along the view.
[[nodiscard]] RayCastSettings limitedTo(const Viewpoint& view, const VolumeGeometry& geometry,
                                        RayCastSettings settings);

}  // namespace echolucent
