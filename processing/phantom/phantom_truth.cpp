#include <algorithm>
#include <cmath>

#include "processing/phantom/phantom.h"
#include "processing/phantom/phantom_scene.h"

namespace echolucent {

namespace {

std::string_view kindName(ImplicitPrimitive::Kind kind) {
    switch (kind) {
        case ImplicitPrimitive::Kind::ellipsoid: return "ellipsoid";
        case ImplicitPrimitive::Kind::roundCone: return "round cone";
        case ImplicitPrimitive::Kind::roundBox: return "round box";
        case ImplicitPrimitive::Kind::cylinder: return "cylinder";
        case ImplicitPrimitive::Kind::wavyPlane: break;
    }
    return "wavy plane";
}

std::vector<double> parametersOf(const ImplicitPrimitive& p) {
    std::vector<double> all;
    const auto add = [&](const Vec3& v) { all.insert(all.end(), v.val, v.val + 3); };
    add(p.centre);
    switch (p.kind) {
        case ImplicitPrimitive::Kind::ellipsoid: add(p.radii); break;
        case ImplicitPrimitive::Kind::roundBox:
            add(p.radii);
            all.push_back(p.rounding);
            break;
        case ImplicitPrimitive::Kind::roundCone:
            add(p.end);
            all.insert(all.end(), {p.radii[0], p.radii[1]});
            return all;
        case ImplicitPrimitive::Kind::cylinder:
            add(p.end);
            all.insert(all.end(), {p.radii[0], p.rounding});
            return all;
        case ImplicitPrimitive::Kind::wavyPlane:
            add({p.axes(0, 2), p.axes(1, 2), p.axes(2, 2)});
            all.insert(all.end(), {p.radii[0], p.radii[1]});
            return all;
    }
    all.insert(all.end(), p.axes.val, p.axes.val + 9);
    return all;
}

struct Span {
    double from, to;
};

/// The part of a line within the volume's box, as parameters of origin + t * direction. Empty if the line misses it.
std::optional<Span> withinBox(const VolumeGeometry& geometry, const Vec3& origin, const Vec3& direction) {
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    Span span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < low[axis] || origin[axis] > high[axis]) return std::nullopt;
            continue;
        }
        double a = (low[axis] - origin[axis]) / direction[axis], b = (high[axis] - origin[axis]) / direction[axis];
        if (a > b) std::swap(a, b);
        span = {std::max(span.from, a), std::min(span.to, b)};
    }
    if (!(span.from < span.to)) return std::nullopt;
    return span;
}

}  // namespace

PhantomTruth::PhantomTruth(const PhantomConfig& config)
    : m_config(config), m_scenery(std::make_shared<const PhantomScenery>(buildScenery(config))) {}

std::vector<PhantomPrimitive> PhantomTruth::primitives() const {
    std::vector<PhantomPrimitive> all;
    for (const PhantomLayer& layer : m_scenery->layers)
        for (const ImplicitBody::Term& term : layer.body.terms())
            all.push_back({term.primitive.name, std::string(kindName(term.primitive.kind)),
                           std::string(nameOf(layer.material)), term.carves, term.seam, layer.echo,
                           parametersOf(term.primitive)});
    return all;
}

double PhantomTruth::echoAt(const Vec3& gridMm) const {
    PaintedEcho painted{m_scenery->tissueEcho, 0, ImplicitBody::far};
    const double inverseRamp = inverseRampPerMm(m_config);
    for (const PhantomLayer& layer : m_scenery->layers)
        painted = paintOver(painted, layer, layer.body.distance(gridMm), inverseRamp);
    return painted.echo;
}

PhantomMaterial PhantomTruth::materialAt(const Vec3& gridMm) const {
    const auto& layers = m_scenery->layers;
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
        if (layer->body.distance(gridMm) <= 0) return layer->material;
    return PhantomMaterial::tissue;
}

double PhantomTruth::fluidDistance(const Vec3& gridMm) const {
    double distance = ImplicitBody::far;
    for (const PhantomLayer& layer : m_scenery->layers) {
        const double own = layer.body.distance(gridMm);
        distance = layer.material == PhantomMaterial::fluid ? std::min(distance, own) : std::max(distance, -own);
    }
    return distance;
}

std::optional<double> PhantomTruth::firstInterface(const Vec3& originMm, const Vec3& direction,
                                                   double nearPlaneDepthMm) const {
    const auto found = firstTransition(originMm, normalized(direction), nearPlaneDepthMm);
    if (!found) return std::nullopt;
    return (found->surface - found->entry) / phantomGeometry(m_config).unit();
}

std::optional<Vec3> PhantomTruth::firstInterfacePoint(const Vec3& originMm, const Vec3& direction,
                                                      double nearPlaneDepthMm) const {
    const Vec3 forward = normalized(direction);
    const auto found = firstTransition(originMm, forward, nearPlaneDepthMm);
    if (!found) return std::nullopt;
    return originMm + forward * found->surface;
}

std::optional<PhantomTruth::Transition> PhantomTruth::firstTransition(const Vec3& originMm, const Vec3& forward,
                                                                      double nearPlaneDepthMm) const {
    constexpr double leastFluid = 8.0, finestStep = 0.25, largestStep = 4.0;  // units
    const VolumeGeometry geometry = phantomGeometry(m_config);
    const auto box = withinBox(geometry, originMm, forward);
    if (!box) return std::nullopt;
    const Span span{std::max(box->from, nearPlaneDepthMm - forward.dot(originMm)), box->to};
    const double unit = geometry.unit();
    const auto distanceAt = [&](double t) { return fluidDistance(originMm + forward * t); };
    // The crossing of the fluid's surface between two parameters on different sides of it.
    const auto crossing = [&](double before, double after, bool beforeIsFluid) {
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (before + after);
            ((distanceAt(middle) < 0) == beforeIsFluid ? before : after) = middle;
        }
        return 0.5 * (before + after);
    };
    double at = span.from, here = distanceAt(at), fluidSince = at;
    while (at < span.to) {
        // Half the distance is safe: the distance functions overstate by less than a factor of 2 near the surfaces.
        const double step = std::clamp(0.5 * std::abs(here), finestStep * unit, largestStep * unit);
        const double next = std::min(span.to, at + step);
        const double there = distanceAt(next);
        if (here >= 0 && there < 0) fluidSince = crossing(at, next, false);
        if (here < 0 && there >= 0) {
            const double surface = crossing(at, next, true);
            if (surface - fluidSince >= leastFluid * unit) return Transition{span.from, surface};
        }
        at = next;
        here = there;
    }
    return std::nullopt;
}

}  // namespace echolucent
