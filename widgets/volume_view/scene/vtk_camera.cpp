#include "widgets/volume_view/scene/vtk_camera.h"

#include <vtkCamera.h>

#include <cmath>
#include <numbers>

namespace echolucent {

Camera cameraOf(vtkCamera& camera) {
    Camera ours;
    ours.focalPoint = Vec3(camera.GetFocalPoint());
    ours.frame.forward = normalized(Vec3(camera.GetDirectionOfProjection()));
    // The up vector need not be perpendicular to the direction.
    ours.frame.right = normalized(ours.frame.forward.cross(Vec3(camera.GetViewUp())));
    ours.frame.down = ours.frame.forward.cross(ours.frame.right);
    ours.distanceMm = camera.GetDistance();
    ours.viewAngleDegrees = camera.GetViewAngle();
    ours.projection = camera.GetParallelProjection() ? Projection::parallel : Projection::perspective;
    ours.heightMm = ours.projection == Projection::parallel
                        ? 2.0 * camera.GetParallelScale()
                        : 2.0 * ours.distanceMm * std::tan(ours.viewAngleDegrees / 2.0 * std::numbers::pi / 180.0);
    return ours;
}

void setCamera(vtkCamera& vtk, const Camera& camera) {
    const Vec3 position = camera.focalPoint - camera.frame.forward * camera.distanceMm;
    const Vec3 up = -camera.frame.down;
    vtk.SetFocalPoint(camera.focalPoint.val);
    vtk.SetPosition(position.val);
    vtk.SetViewUp(up.val);
    vtk.SetParallelProjection(camera.projection == Projection::parallel);
    vtk.SetParallelScale(camera.heightMm / 2.0);
    vtk.SetViewAngle(camera.viewAngleDegrees);
}

}  // namespace echolucent
