#include "widgets/volume_view/scene/vtk_camera.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace echolucent {

Camera cameraOf(vtkCamera& camera) {
    Camera ours;
    ours.focalPoint = Vec3(camera.GetFocalPoint());
    ours.frame.forward = normalized(Vec3(camera.GetDirectionOfProjection()));
    // VTK's up vector may be oblique to the direction.
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

void setClippingRange(vtkCamera& vtk, const std::array<double, 6>& bounds) {
    constexpr double margin = 0.01;         // of the range
    constexpr double nearestShare = 0.001;  // of the far plane's distance; any nearer, the depth buffer is too coarse
    const Vec3 forward(vtk.GetDirectionOfProjection()), position(vtk.GetPosition());
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const Vec3 point(bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)]);
        const double depth = forward.dot(point - position);
        from = std::min(from, depth);
        to = std::max(to, depth);
    }
    // Flat things across the view need a range too.
    const double reach = std::max({margin * (to - from), 1e-6 * std::abs(to), 1e-6});
    from -= reach;
    to += reach;
    if (!vtk.GetParallelProjection()) {
        to = std::max(to, reach);
        from = std::max(from, nearestShare * to);
    }
    vtk.SetClippingRange(from, to);
}

}  // namespace echolucent
