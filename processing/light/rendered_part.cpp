#include "processing/light/rendered_part.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

double thicknessAlong(const Vec3& normal, const Vec3& placeMm) {
    return std::abs(normal[0]) * placeMm[0] + std::abs(normal[1]) * placeMm[1] + std::abs(normal[2]) * placeMm[2];
}

}  // namespace

RenderedShares::RenderedShares(const RenderedPart& part, const Vec3& placeMm) {
    if (part.front) addFace(part.front->inwards, part.front->depthMm, placeMm);
    for (const ClippingPlane& plane : part.clippingPlanes) {
        const Vec3 normal = normalized(plane.normal);
        addFace(normal, normal.dot(plane.point), placeMm);
    }
    for (int axis = 0; axis < 3 && part.box; ++axis) {
        Vec3 normal{0, 0, 0};
        normal[axis] = 1.0;
        addFace(normal, part.box->low[axis], placeMm);
        addFace(-normal, -part.box->high[axis], placeMm);
    }
    m_surface = part.cutSurface;
    if (m_surface) m_surfaceThicknessMm = thicknessAlong(m_surface->frame.forward, placeMm);
}

void RenderedShares::addFace(const Vec3& normal, double depth, const Vec3& placeMm) {
    if (!std::isfinite(depth)) return;
    m_faces.push_back({normal, depth, thicknessAlong(normal, placeMm)});
}

void RenderedShares::multiplyRowByFaces(const Vec3& firstMm, double stepMm, int count, float* values) const {
    for (const Face& face : m_faces) {
        const auto first = static_cast<float>((face.normal.dot(firstMm) - face.depth) / face.thicknessMm + 0.5);
        const auto step = static_cast<float>(face.normal[0] * stepMm / face.thicknessMm);
        const auto last = first + step * static_cast<float>(count - 1);
        if (std::min(first, last) >= 1.0f) continue;
        for (int x = 0; x < count; ++x)
            values[x] *= std::min(std::max(first + step * static_cast<float>(x), 0.0f), 1.0f);
    }
}

void RenderedShares::surfaceShares(const Vec3& firstMm, double stepMm, int count, float* shares) const {
    for (int x = 0; x < count; ++x) {
        const Vec3 place = firstMm + Vec3(stepMm * x, 0, 0);
        const double behind = m_surface->frame.forward.dot(place) - m_surface->depthAt(place);
        shares[x] = static_cast<float>(std::clamp(behind / m_surfaceThicknessMm + 0.5, 0.0, 1.0));
    }
}

bool RenderedShares::contains(const Vec3& gridMm) const {
    return std::all_of(m_faces.begin(), m_faces.end(),
                       [&](const Face& face) { return face.normal.dot(gridMm) >= face.depth; }) &&
           !(m_surface && m_surface->cutsAway(gridMm));
}

}  // namespace echolucent
