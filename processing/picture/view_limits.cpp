#include "processing/picture/view_limits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "processing/viewpoint/box_section.h"

namespace echolucent {

namespace {

/// The grid axis along which a direction runs. -1 if it is oblique.
int gridAxisOf(const Vec3& direction) {
    constexpr double rounding = 1e-12;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 across = direction;
        across[axis] = 0.0;
        if (length(across) < rounding) return axis;
    }
    return -1;
}

bool liesAlongGrid(const ViewFrame& axes) {
    return gridAxisOf(axes.right) >= 0 && gridAxisOf(axes.down) >= 0 && gridAxisOf(axes.forward) >= 0;
}

/// Faces along the grid's axes as a box. The box reaches beyond the volume on sides without a face.
RenderBox boxOf(const std::vector<CuttingFace>& faces, const VolumeGeometry& geometry) {
    const Vec3 beyond = geometry.boxMaxMm() - geometry.boxMinMm();
    RenderBox box{geometry.boxMinMm() - beyond, geometry.boxMaxMm() + beyond};
    for (const CuttingFace& face : faces) {
        const int axis = gridAxisOf(face.inwards);
        (face.inwards[axis] > 0.0 ? box.low : box.high)[axis] = face.depthMm * face.inwards[axis];
    }
    return box;
}

}  // namespace

RayCastSettings limitedTo(const Viewpoint& view, const VolumeGeometry& geometry, RayCastSettings settings) {
    settings.front.reset();
    if (view.frontPlane) settings.front = cuttingFaceOf(*view.frontPlane, geometry);
    settings.cutSurface = view.cutSurface;
    settings.box.reset();
    settings.clippingPlanes.clear();
    if (!view.box) return settings;
    const std::vector<CuttingFace> faces = facesThatCut(*view.box, geometry);
    if (faces.empty()) return settings;
    if (liesAlongGrid(view.box->axes))
        settings.box = boxOf(faces, geometry);
    else
        std::ranges::transform(faces, std::back_inserter(settings.clippingPlanes), [](const CuttingFace& face) {
            return ClippingPlane{face.inwards * face.depthMm, face.inwards};
        });
    return settings;
}

double nearestDepthMm(const RayCastSettings& settings, const VolumeGeometry& geometry) {
    const Vec3& forward = settings.camera.frame.forward;
    const double foremost = geometry.depthsAlong(forward).nearest;
    if (!settings.front) return foremost;
    const CuttingFace& front = *settings.front;
    if (front.inwards == forward) return std::max(foremost, front.depthMm);
    const OrientedBox box = orientedBoxOf(DataBox(geometry));
    std::vector<Vec3> corners = sectionOf(box, front.inwards * front.depthMm, front.inwards).corners;
    std::ranges::copy_if(box.corners(), std::back_inserter(corners),
                         [&](const Vec3& corner) { return front.inwards.dot(corner) >= front.depthMm; });
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners) nearest = std::min(nearest, forward.dot(corner));
    return std::isfinite(nearest) ? nearest : foremost;  // a front that leaves nothing colours nothing
}

}  // namespace echolucent
