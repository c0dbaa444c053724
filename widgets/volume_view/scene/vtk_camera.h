// Converts between VTK's camera and ours. VTK's y is up and its camera looks from a position. Ours has a frame whose
// second axis is down.
#pragma once

#include <array>

#include "processing/picture/camera.h"

class vtkCamera;

namespace echolucent {

/// VTK's camera as ours: parallel and perspective, roll included.
[[nodiscard]] Camera cameraOf(vtkCamera& camera);

/// Makes VTK's camera look as ours does. The clipping planes of VTK's camera stay where they are.
void setCamera(vtkCamera& vtk, const Camera& camera);

/// Puts the camera's clipping planes around a box (grid mm; x from, x to, y from, ...). Unlike with
/// vtkRenderer::ResetCameraClippingRange(), a parallel camera also shows what lies behind its position, as rays do.
void setClippingRange(vtkCamera& vtk, const std::array<double, 6>& bounds);

}  // namespace echolucent
