// Smooth bodies in closed form: signed distance functions joined and carved with rounded seams. The simulated scans are
// drawn from them, and their true surfaces are computed from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "processing/phantom/implicit_primitive.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// A similarity that places a drawing: it maps local coordinates to grid mm. `axes` is orthonormal; its columns are the
/// images of the local axes. `scale` is mm per local unit.
struct Placement {
    Mat3 axes = Mat3::eye();
    Vec3 origin{0, 0, 0};
    double scale = 1.0;

    [[nodiscard]] Vec3 point(const Vec3& local) const { return origin + axes * local * scale; }
    /// Places by `inner` first, then by this: (a * b).point(p) == a.point(b.point(p)).
    [[nodiscard]] Placement operator*(const Placement& inner) const {
        return {axes * inner.axes, point(inner.origin), scale * inner.scale};
    }
};

[[nodiscard]] ImplicitPrimitive ellipsoid(std::string name, const Vec3& centre, const Vec3& radii,
                                          const Mat3& axes = Mat3::eye());
[[nodiscard]] ImplicitPrimitive sphere(std::string name, const Vec3& centre, double radius);
/// A capsule whose radius changes linearly from one end to the other.
[[nodiscard]] ImplicitPrimitive roundCone(std::string name, const Vec3& from, const Vec3& to, double fromRadius,
                                          double toRadius);
[[nodiscard]] ImplicitPrimitive roundBox(std::string name, const Vec3& centre, const Vec3& halfSize, double rounding,
                                         const Mat3& axes = Mat3::eye());
[[nodiscard]] ImplicitPrimitive cylinder(std::string name, const Vec3& from, const Vec3& to, double radius,
                                         double rounding);
/// The half space behind a plane (against its normal) whose surface is gently waved along x and y.
[[nodiscard]] ImplicitPrimitive wavyPlane(std::string name, const Vec3& point, const Vec3& normal, double waveDepth,
                                          double waveLength);

/// The primitive, moved, turned and scaled by the placement.
[[nodiscard]] ImplicitPrimitive placed(const Placement& placement, ImplicitPrimitive primitive);

/// Signed distance in mm at a point in grid mm.
[[nodiscard]] double signedDistance(const ImplicitPrimitive& primitive, const Vec3& point);

/// Radius of a ball around the point that surely lies inside the primitive. 0 or less if the point may be outside.
[[nodiscard]] double innerRadius(const ImplicitPrimitive& primitive, const Vec3& point);

/// Radius of a ball around the point that surely lies outside the primitive. 0 or less if the point may be inside.
[[nodiscard]] double outerRadius(const ImplicitPrimitive& primitive, const Vec3& point);

/// Smooth minimum with a seam of finite width (polynomial): the plain minimum where |a - b| >= width.
[[nodiscard]] inline double smoothMinimum(double a, double b, double width) {
    const double share = width > 0.0 ? std::max(width - std::abs(a - b), 0.0) / width : 0.0;
    return std::min(a, b) - share * share * width * 0.25;
}

/// A body made of primitives in order. Each is joined to the body or carved out of it, with a rounded seam.
class ImplicitBody {
public:
    static constexpr double far = 1e6;  ///< distance to an empty body, mm

    /// `seam` is the width of the rounded seam in mm; 0 makes a sharp one.
    void join(ImplicitPrimitive primitive, double seam = 0.0) { add(std::move(primitive), seam, false); }
    void carve(ImplicitPrimitive primitive, double seam = 0.0) { add(std::move(primitive), seam, true); }

    struct Term {
        ImplicitPrimitive primitive;
        double seam = 0.0;
        bool carves = false;
        double reach = 0.0;  ///< how far beyond its surface it matters: the widest seam of it and all later terms
    };
    [[nodiscard]] const std::vector<Term>& terms() const { return m_terms; }

    /// Signed distance in mm, negative inside.
    [[nodiscard]] double distance(const Vec3& point) const;

    /// The place of a ball relative to the body and a band of `band` mm about its surface.
    enum class Standing { outside, inside, mixed };
    /// If the ball is mixed, `active` gets the places in terms() of those that can matter within it. The other terms
    /// change only distances beyond +-band.
    [[nodiscard]] Standing standingOf(const Vec3& centre, double radius, double band, std::vector<int>& active) const;

private:
    void add(ImplicitPrimitive primitive, double seam, bool carves);
    std::vector<Term> m_terms;
};

}  // namespace echolucent
