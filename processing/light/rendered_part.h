// The part of a volume that is rendered. Light asks for it, because what is cut away attenuates no light.
#pragma once

#include <optional>
#include <vector>

#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// The part of a volume that is rendered, as RayCastSettings says it.
struct RenderedPart {
    std::optional<CuttingFace> front;
    std::optional<RenderBox> box;
    std::vector<ClippingPlane> clippingPlanes;
    std::optional<CutSurface> cutSurface;
    friend bool operator==(const RenderedPart&, const RenderedPart&) = default;
};

/// The share of each place that is rendered. The share rises linearly along a face's normal over the place's thickness,
/// so that light does not jump from place to place along an oblique face.
class RenderedShares {
public:
    /// `placeMm` is the size of a place of the light's grid along x, y, z, each above 0. Throws std::invalid_argument
    /// if the normal of a clipping plane is 0.
    RenderedShares(const RenderedPart& part, const Vec3& placeMm);

    [[nodiscard]] bool everywhere() const { return m_faces.empty() && !m_surface; }
    /// Multiplies `count` values by the shares of the places at firstMm, firstMm + (stepMm,0,0), ... that the faces of
    /// front, box and clipping planes leave. Only here and in surfaceShares() light asks whether something is rendered.
    void multiplyRowByFaces(const Vec3& firstMm, double stepMm, int count, float* values) const;
    /// The surface that cuts, if any.
    [[nodiscard]] const std::optional<CutSurface>& surface() const { return m_surface; }
    /// The shares that the surface leaves of these places. There must be a surface().
    void surfaceShares(const Vec3& firstMm, double stepMm, int count, float* shares) const;
    /// Whether a place in grid mm is rendered, exactly.
    [[nodiscard]] bool contains(const Vec3& gridMm) const;

private:
    /// A place is rendered if normal . place >= depth; mm.
    struct Face {
        Vec3 normal;
        double depth;
        double thicknessMm;  ///< of a place along the normal
    };
    void addFace(const Vec3& normal, double depth, const Vec3& placeMm);

    std::vector<Face> m_faces;
    std::optional<CutSurface> m_surface;
    double m_surfaceThicknessMm = 0.0;  ///< of a place along the surface's forward
};

}  // namespace echolucent
