// A fetus in profile in its fluid sac, with cord, placenta and uterine wall, as in a scan through the mother's belly.
// The sac opens towards the probe.
#include <array>
#include <cmath>
#include <numbers>

#include "processing/phantom/phantom_fetus.h"
#include "processing/phantom/phantom_scene.h"

namespace echolucent {

namespace {

/// Reclining in the picture: crown to the upper left, face to the upper right, a little turned to the viewer.
Placement fetusPlacement(const Placement& scene) {
    // Columns: anterior to the right, crown up, near side towards the probe.
    const Mat3 upright{1, 0, 0, 0, -1, 0, 0, 0, -1};
    Placement fetus;
    fetus.axes = rotationZ(-32) * upright * rotationY(-16);
    fetus.origin = {0.435, 0.535, 0.47};
    fetus.scale = 0.85;
    return scene * fetus;
}

ImplicitBody amnioticSac(const Placement& placement) {
    ImplicitBody sac;
    Sculpture fluid{sac, placement};
    fluid.join(roundBox("sac at the probe", {0.5, 0.5, 0.05}, {0.49, 0.49, 0.5}, 0.30), 0);
    fluid.join(ellipsoid("sac", {0.5, 0.5, 0.42}, {0.50, 0.49, 0.42}), 0.10);
    fluid.carve(ellipsoid("bulge of the wall", {0.06, 0.95, 0.60}, {0.20, 0.18, 0.22}), 0.12);
    fluid.carve(ellipsoid("bulge of the wall", {0.97, 0.03, 0.62}, {0.18, 0.17, 0.24}), 0.12);
    fluid.carve(ellipsoid("bulge of the wall", {0.20, 0.02, 0.70}, {0.26, 0.16, 0.20}), 0.12);
    return sac;
}

ImplicitBody placenta(const Placement& placement) {
    ImplicitBody body;
    Sculpture part{body, placement};
    part.join(ellipsoid("placenta", {0.86, 0.46, 0.80}, {0.24, 0.34, 0.20}, rotationY(-40)), 0);
    part.join(ellipsoid("lobe of the placenta", {0.76, 0.30, 0.79}, {0.12, 0.12, 0.10}), 0.06);
    part.join(ellipsoid("lobe of the placenta", {0.74, 0.60, 0.79}, {0.11, 0.13, 0.10}), 0.06);
    return body;
}

/// A point of the cubic curve through four control points (Bezier).
Vec3 onCurve(const std::array<Vec3, 4>& control, double t) {
    const double s = 1 - t;
    return control[0] * (s * s * s) + control[1] * (3 * s * s * t) + control[2] * (3 * s * t * t) +
           control[3] * (t * t * t);
}

/// The cord: two strands wound about a curve from the navel to the placenta.
void addCord(ImplicitBody& body, const Placement& scene, const Placement& fetus) {
    const Vec3 navel = fetus.point({0.16, -0.19, 0.0});
    const std::array<Vec3, 4> control{navel, fetus.point({0.36, -0.10, 0.22}), scene.point({0.80, 0.36, 0.30}),
                                      scene.point({0.80, 0.44, 0.66})};
    constexpr int pieces = 44;
    constexpr double turns = 5.5;
    const double winding = 0.0125 * scene.scale, strand = 0.0150 * scene.scale;
    const auto strandPoint = [&](double t, double start) {
        const Vec3 tangent = normalized(onCurve(control, t + 0.005) - onCurve(control, t - 0.005));
        const Vec3 side = normalized(tangent.cross(Vec3(0.3, 0.2, 1)));
        const Vec3 other = tangent.cross(side);
        const double angle = 2 * std::numbers::pi * (turns * t + start);
        return onCurve(control, t) + (side * std::cos(angle) + other * std::sin(angle)) * winding;
    };
    for (const double start : {0.0, 0.5})
        for (int piece = 0; piece < pieces; ++piece) {
            const double from = static_cast<double>(piece) / pieces, to = static_cast<double>(piece + 1) / pieces;
            body.join(roundCone("cord", strandPoint(from, start), strandPoint(to, start), strand, strand),
                      0.004 * scene.scale);
        }
}

}  // namespace

void addFetus(PhantomScenery& scenery, const Placement& scene, const PhantomConfig& config) {
    const Placement fetus = fetusPlacement(scene);
    const auto between = [&](double share) { return config.tissue + share * (config.object - config.tissue); };
    const auto add = [&](ImplicitBody body, PhantomMaterial material, double echo, double shadowing) {
        scenery.layers.push_back({std::move(body), material, echo, shadowing});
    };
    FetusBodies bodies;
    addTrunk(bodies, fetus, config.phase);
    addHead(bodies, fetus);
    addArms(bodies, fetus, config.phase);
    addLegs(bodies, fetus);
    ImplicitBody cord;
    addCord(cord, scene, fetus);

    add(amnioticSac(scene), PhantomMaterial::fluid, config.fluid, 0);
    add(placenta(scene), PhantomMaterial::tissue, between(0.12), 0);
    add(std::move(cord), PhantomMaterial::tissue, between(0.55), 0);
    add(std::move(bodies.flesh), PhantomMaterial::tissue, between(0.65), 0);
    add(std::move(bodies.chambers), PhantomMaterial::fluid, config.fluid, 0);
    add(std::move(bodies.bone), PhantomMaterial::object, config.object, 1);
}

}  // namespace echolucent
