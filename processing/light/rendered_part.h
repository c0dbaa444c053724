// What is rendered of a volume, as light asks for it: what is cut away attenuates no light.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// What is rendered of a volume, as RayCastSettings says it.
struct RenderedPart {
    Vec3 forward{0, 0, 1};  ///< grid mm, unit: the direction along which the near plane's depth is counted
    double nearPlaneDepthMm = -std::numeric_limits<double>::infinity();  ///< from the grid origin along `forward`
    std::optional<RenderBox> box;
    std::vector<ClippingPlane> clippingPlanes;
    std::optional<CutSurface> cutSurface;
    friend bool operator==(const RenderedPart&, const RenderedPart&) = default;
};

/// The share of a place that is rendered, for many places. A face that passes through a place takes as much of it as if
/// it stood across, so that light does not jump from place to place along an oblique face.
class RenderedShares {
public:
    /// `placeMm` is the size of a place along x, y, z, each above 0. Throws std::invalid_argument for a plane without
    /// normal.
    RenderedShares(const RenderedPart& part, const Vec3& placeMm);

    [[nodiscard]] bool everywhere() const { return m_faces.empty() && !m_surface; }
    /// Multiplies `count` values by the shares of the places at firstMm, firstMm + (stepMm,0,0), ... This is where
    /// light asks whether something is rendered, and nowhere else.
    void multiplyRow(const Vec3& firstMm, double stepMm, int count, float* values) const;
    /// Whether a place in grid mm is rendered, exactly.
    [[nodiscard]] bool contains(const Vec3& gridMm) const;

private:
    /// It is rendered where normal . place >= depth; mm.
    struct Face {
        Vec3 normal;
        double depth;
        double thicknessMm;  ///< of a place along the normal
    };
    void addFace(const Vec3& normal, double depth, const Vec3& placeMm);
    void multiplyRowBySurface(const Vec3& firstMm, double stepMm, int count, float* values) const;

    std::vector<Face> m_faces;
    std::optional<CutSurface> m_surface;
    double m_surfaceThicknessMm = 0.0;  ///< of a place along the surface's forward
};

}  // namespace echolucent
