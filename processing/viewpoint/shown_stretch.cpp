#include "processing/viewpoint/shown_stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "processing/viewpoint/oriented_box.h"

namespace echolucent {

namespace {

using Stretch = CutSurface::Stretch;

/// The part of a stretch behind all faces; no value if nothing is left.
std::optional<Stretch> behindFaces(const std::vector<CuttingFace>& faces, const Vec3& point, const Vec3& direction,
                                   Stretch stretch) {
    constexpr double alongFace = 1e-9;
    for (const CuttingFace& face : faces) {
        const double behind = face.inwards.dot(point) - face.depthMm, slope = face.inwards.dot(direction);
        if (std::abs(slope) < alongFace) {
            if (behind < 0.0) return std::nullopt;
            continue;
        }
        const double crossing = -behind / slope;
        if (slope > 0.0)
            stretch.begin = std::max(stretch.begin, crossing);
        else
            stretch.end = std::min(stretch.end, crossing);
    }
    if (!(stretch.end > stretch.begin)) return std::nullopt;
    return stretch;
}

/// The part of a line between two corners of the volume's box and behind a depth along the line; no value if there is
/// none.
std::optional<Stretch> inBox(const Vec3& low, const Vec3& high, const Vec3& point, const Vec3& direction,
                             double nearDepth) {
    Stretch stretch{nearDepth - direction.dot(point), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (point[axis] < low[axis] || point[axis] > high[axis]) return std::nullopt;
            continue;
        }
        const double atLow = (low[axis] - point[axis]) / direction[axis];
        const double atHigh = (high[axis] - point[axis]) / direction[axis];
        stretch.begin = std::max(stretch.begin, std::min(atLow, atHigh));
        stretch.end = std::min(stretch.end, std::max(atLow, atHigh));
    }
    if (!(stretch.end > stretch.begin)) return std::nullopt;
    return stretch;
}

}  // namespace

ShownStretches::ShownStretches(const Viewpoint& view, const VolumeGeometry& geometry)
    : m_forward(frameOf(view).forward),
      m_low(geometry.boxMinMm()),
      m_high(geometry.boxMaxMm()),
      m_nearDepth(nearPlaneDepthMm(view, geometry)),
      m_cutSurface(view.cutSurface) {
    if (view.box) m_faces = facesThatCut(*view.box, geometry);
    if (hasObliqueFront(view)) m_faces.push_back(cuttingFaceOf(*view.frontPlane, geometry));
}

std::optional<Stretch> ShownStretches::of(const Vec3& pointMm) const {
    auto stretch = inBox(m_low, m_high, pointMm, m_forward, m_nearDepth);
    if (stretch) stretch = behindFaces(m_faces, pointMm, m_forward, *stretch);
    return stretch && m_cutSurface ? m_cutSurface->firstLeft(pointMm, m_forward, *stretch) : stretch;
}

}  // namespace echolucent
