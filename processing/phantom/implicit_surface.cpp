#include "processing/phantom/implicit_surface.h"

#include <numbers>
#include <utility>

#include "processing/phantom/implicit_distance.h"

namespace echolucent {

namespace {

double largest(const Vec3& v) { return std::max({v[0], v[1], v[2]}); }
double smallest(const Vec3& v) { return std::min({v[0], v[1], v[2]}); }

}  // namespace

void ImplicitPrimitive::prepare() {
    switch (kind) {
        case Kind::ellipsoid:
            inverseRadii = {1 / radii[0], 1 / radii[1], 1 / radii[2]};
            boundCentre = centre;
            boundRadius = largest(radii);
            break;
        case Kind::roundBox:
            boundCentre = centre;
            boundRadius = length(radii);
            break;
        case Kind::roundCone:
        case Kind::cylinder: {
            along = end - centre;
            const double lengthSquared = along.dot(along);
            inverseLengthSquared = lengthSquared > 0 ? 1 / lengthSquared : 0;
            const double reach = kind == Kind::cylinder ? radii[0] : std::max(radii[0], radii[1]);
            if (kind == Kind::roundCone) {
                const double taper = radii[1] - radii[0];
                slant = 1 / std::sqrt(1 + taper * taper * inverseLengthSquared);
            }
            boundCentre = (centre + end) * 0.5;
            boundRadius = 0.5 * std::sqrt(lengthSquared) + reach;
            break;
        }
        case Kind::wavyPlane: {
            const double steepness = 2 * std::numbers::pi * radii[0] / radii[1];
            slant = 1 / std::sqrt(1 + steepness * steepness);
            boundCentre = centre;
            boundRadius = std::numeric_limits<double>::infinity();
            break;
        }
    }
}

ImplicitPrimitive ellipsoid(std::string name, const Vec3& centre, const Vec3& radii, const Mat3& axes) {
    ImplicitPrimitive made{.kind = ImplicitPrimitive::Kind::ellipsoid, .name = std::move(name)};
    made.centre = centre;
    made.radii = radii;
    made.axes = axes;
    made.prepare();
    return made;
}

ImplicitPrimitive sphere(std::string name, const Vec3& centre, double radius) {
    return ellipsoid(std::move(name), centre, {radius, radius, radius});
}

ImplicitPrimitive roundCone(std::string name, const Vec3& from, const Vec3& to, double fromRadius, double toRadius) {
    ImplicitPrimitive made{.kind = ImplicitPrimitive::Kind::roundCone, .name = std::move(name)};
    made.centre = from;
    made.end = to;
    made.radii = {fromRadius, toRadius, 0};
    made.prepare();
    return made;
}

ImplicitPrimitive roundBox(std::string name, const Vec3& centre, const Vec3& halfSize, double rounding,
                           const Mat3& axes) {
    ImplicitPrimitive made{.kind = ImplicitPrimitive::Kind::roundBox, .name = std::move(name)};
    made.centre = centre;
    made.radii = halfSize;
    made.axes = axes;
    made.rounding = std::min(rounding, smallest(halfSize));
    made.prepare();
    return made;
}

ImplicitPrimitive cylinder(std::string name, const Vec3& from, const Vec3& to, double radius, double rounding) {
    ImplicitPrimitive made{.kind = ImplicitPrimitive::Kind::cylinder, .name = std::move(name)};
    made.centre = from;
    made.end = to;
    made.radii = {radius, 0, 0};
    made.rounding = std::min(rounding, radius);
    made.prepare();
    return made;
}

ImplicitPrimitive wavyPlane(std::string name, const Vec3& point, const Vec3& normal, double waveDepth,
                            double waveLength) {
    ImplicitPrimitive made{.kind = ImplicitPrimitive::Kind::wavyPlane, .name = std::move(name)};
    made.centre = point;
    const Vec3 outward = normalized(normal);
    for (int row = 0; row < 3; ++row) made.axes(row, 2) = outward[row];
    made.radii = {waveDepth, waveLength, 0};
    made.prepare();
    return made;
}

ImplicitPrimitive placed(const Placement& placement, ImplicitPrimitive primitive) {
    primitive.centre = placement.point(primitive.centre);
    primitive.end = placement.point(primitive.end);
    primitive.axes = placement.axes * primitive.axes;
    primitive.radii = primitive.radii * placement.scale;
    primitive.rounding *= placement.scale;
    primitive.prepare();
    return primitive;
}

double signedDistance(const ImplicitPrimitive& primitive, const Vec3& point) {
    return withDistanceFunction(primitive,
                                [&](const auto& distance) { return distance(point[0], point[1], point[2]); });
}

double innerRadius(const ImplicitPrimitive& primitive, const Vec3& point) {
    if (primitive.kind != ImplicitPrimitive::Kind::ellipsoid) {
        // A cone's distance is exact on its side. Elsewhere inside, it overstates by no more than the factor 1 / slant.
        return -signedDistance(primitive, point) * primitive.slant;
    }
    const Vec3 local = primitive.axes.t() * (point - primitive.centre);
    return (1 - length(local.mul(primitive.inverseRadii))) * smallest(primitive.radii);
}

double outerRadius(const ImplicitPrimitive& primitive, const Vec3& point) {
    // Outside, only the ellipsoid's distance function can overstate.
    if (primitive.kind != ImplicitPrimitive::Kind::ellipsoid) return signedDistance(primitive, point);
    return -innerRadius(primitive, point);
}

void ImplicitBody::add(ImplicitPrimitive primitive, double seam, bool carves) {
    m_terms.push_back({std::move(primitive), seam, carves, seam});
    for (Term& term : m_terms) term.reach = std::max(term.reach, seam);
}

double ImplicitBody::distance(const Vec3& point) const {
    double result = far;
    for (const Term& term : m_terms) {
        const double next = signedDistance(term.primitive, point);
        result = term.carves ? -smoothMinimum(-result, next, term.seam) : smoothMinimum(result, next, term.seam);
    }
    return result;
}

ImplicitBody::Standing ImplicitBody::standingOf(const Vec3& centre, double radius, double band,
                                                std::vector<int>& active) const {
    active.clear();
    bool joined = false, carved = false, within = false;
    for (std::size_t index = 0; index < m_terms.size(); ++index) {
        const Term& term = m_terms[index];
        const ImplicitPrimitive& primitive = term.primitive;
        const double reach = radius + band + term.reach;
        const Vec3 offset = centre - primitive.boundCentre;
        const double bound = primitive.boundRadius + reach;
        if (offset.dot(offset) > bound * bound || outerRadius(primitive, centre) > reach) continue;
        active.push_back(static_cast<int>(index));
        (term.carves ? carved : joined) = true;
        within = within || (!term.carves && innerRadius(primitive, centre) > radius + band);
    }
    if (!joined) return Standing::outside;
    return within && !carved ? Standing::inside : Standing::mixed;
}

}  // namespace echolucent
