// The distance functions of implicit_primitive.h as small function objects. So a loop over many voxels chooses the kind
// of primitive once.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/phantom/implicit_primitive.h"

namespace echolucent {

/// Position of a point in the local axes of a primitive, relative to its centre.
struct LocalFrame {
    double cx, cy, cz;
    double m[9];
    explicit LocalFrame(const ImplicitPrimitive& p) : cx(p.centre[0]), cy(p.centre[1]), cz(p.centre[2]) {
        for (int i = 0; i < 9; ++i) m[i] = p.axes.val[i];
    }
    [[nodiscard]] Vec3 operator()(double x, double y, double z) const {
        const double dx = x - cx, dy = y - cy, dz = z - cz;
        return {m[0] * dx + m[3] * dy + m[6] * dz, m[1] * dx + m[4] * dy + m[7] * dz,
                m[2] * dx + m[5] * dy + m[8] * dz};
    }
};

/// With q the point in local axes and r the radii, the distance is |q/r| (|q/r| - 1) / |q/r^2|. It is exact to first
/// order at the surface. At the centre it is minus the smallest radius.
struct EllipsoidDistance {
    LocalFrame local;
    Vec3 inverse;
    double core;
    explicit EllipsoidDistance(const ImplicitPrimitive& p)
        : local(p), inverse(p.inverseRadii), core(-std::min({p.radii[0], p.radii[1], p.radii[2]})) {}
    [[nodiscard]] double operator()(double x, double y, double z) const {
        const Vec3 q = local(x, y, z);
        const double a = q[0] * inverse[0], b = q[1] * inverse[1], c = q[2] * inverse[2];
        const double first = a * a + b * b + c * c;
        const double u = a * inverse[0], v = b * inverse[1], w = c * inverse[2];
        const double second = u * u + v * v + w * w;
        if (second < 1e-24) return core;
        const double share = std::sqrt(first);
        return share * (share - 1) / std::sqrt(second);
    }
};

struct RoundConeDistance {
    const ImplicitPrimitive& p;
    explicit RoundConeDistance(const ImplicitPrimitive& primitive) : p(primitive) {}
    [[nodiscard]] double operator()(double x, double y, double z) const {
        const double dx = x - p.centre[0], dy = y - p.centre[1], dz = z - p.centre[2];
        const double t =
            std::clamp((dx * p.along[0] + dy * p.along[1] + dz * p.along[2]) * p.inverseLengthSquared, 0.0, 1.0);
        const double ex = dx - t * p.along[0], ey = dy - t * p.along[1], ez = dz - t * p.along[2];
        return (std::sqrt(ex * ex + ey * ey + ez * ez) - (p.radii[0] + t * (p.radii[1] - p.radii[0]))) * p.slant;
    }
};

struct RoundBoxDistance {
    LocalFrame local;
    Vec3 half;
    double rounding;
    explicit RoundBoxDistance(const ImplicitPrimitive& p)
        : local(p), half(p.radii - Vec3(p.rounding, p.rounding, p.rounding)), rounding(p.rounding) {}
    [[nodiscard]] double operator()(double x, double y, double z) const {
        const Vec3 q = local(x, y, z);
        const double a = std::abs(q[0]) - half[0], b = std::abs(q[1]) - half[1], c = std::abs(q[2]) - half[2];
        const double u = std::max(a, 0.0), v = std::max(b, 0.0), w = std::max(c, 0.0);
        return std::sqrt(u * u + v * v + w * w) + std::min(std::max({a, b, c}), 0.0) - rounding;
    }
};

struct CylinderDistance {
    const ImplicitPrimitive& p;
    double half;
    explicit CylinderDistance(const ImplicitPrimitive& primitive) : p(primitive), half(0.5 * length(p.along)) {}
    [[nodiscard]] double operator()(double x, double y, double z) const {
        const double dx = x - p.centre[0], dy = y - p.centre[1], dz = z - p.centre[2];
        const double t = (dx * p.along[0] + dy * p.along[1] + dz * p.along[2]) * p.inverseLengthSquared;
        const double ex = dx - t * p.along[0], ey = dy - t * p.along[1], ez = dz - t * p.along[2];
        const double a = std::sqrt(ex * ex + ey * ey + ez * ez) - p.radii[0] + p.rounding;
        const double b = (std::abs(t - 0.5) * 2 - 1) * half + p.rounding;
        const double u = std::max(a, 0.0), v = std::max(b, 0.0);
        return std::sqrt(u * u + v * v) + std::min(std::max(a, b), 0.0) - p.rounding;
    }
};

struct WavyPlaneDistance {
    const ImplicitPrimitive& p;
    double wave;
    explicit WavyPlaneDistance(const ImplicitPrimitive& primitive)
        : p(primitive), wave(2 * std::numbers::pi / primitive.radii[1]) {}
    [[nodiscard]] double operator()(double x, double y, double z) const {
        const double height =
            (x - p.centre[0]) * p.axes(0, 2) + (y - p.centre[1]) * p.axes(1, 2) + (z - p.centre[2]) * p.axes(2, 2);
        return (height - p.radii[0] * std::sin(wave * x) * std::cos(wave * y)) * p.slant;
    }
};

/// Calls `use` with the primitive's distance function: double(double x, double y, double z), grid mm.
template <typename Use>
auto withDistanceFunction(const ImplicitPrimitive& primitive, const Use& use) {
    switch (primitive.kind) {
        case ImplicitPrimitive::Kind::ellipsoid: return use(EllipsoidDistance(primitive));
        case ImplicitPrimitive::Kind::roundCone: return use(RoundConeDistance(primitive));
        case ImplicitPrimitive::Kind::roundBox: return use(RoundBoxDistance(primitive));
        case ImplicitPrimitive::Kind::cylinder: return use(CylinderDistance(primitive));
        case ImplicitPrimitive::Kind::wavyPlane: break;
    }
    return use(WavyPlaneDistance(primitive));
}

}  // namespace echolucent
