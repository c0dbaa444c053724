// VTK's camera and ours. VTK's y is up and its camera looks from a position; ours has a frame whose second axis is down.
#pragma once

#include "processing/ray_caster.h"

class vtkCamera;

namespace echolucent {

/// The camera VTK looks through, as ours: parallel and perspective, roll included.
[[nodiscard]] Camera cameraOf(vtkCamera& camera);

/// Makes VTK look through ours. Clipping planes are left to vtkRenderer::ResetCameraClippingRange().
void setCamera(vtkCamera& vtk, const Camera& camera);

}  // namespace echolucent
