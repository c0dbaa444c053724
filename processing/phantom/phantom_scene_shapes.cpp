// The paper's artificial scene (Petersch 2005, section 5): an ellipsoid, a cylinder and various spheres of high
// intensity behind a window of fluid in tissue.
#include "processing/phantom/phantom_scene.h"

namespace echolucent {

void addShapes(PhantomScenery& scenery, const Placement& placement, const PhantomConfig& config) {
    PhantomLayer window{.body = {}, .material = PhantomMaterial::fluid, .echo = config.fluid};
    // The window reaches beyond the probe's face, so that most rays meet fluid first.
    window.body.join(placed(placement, roundBox("window of fluid", {0.46, 0.5, 0.22}, {0.37, 0.40, 0.52}, 0.16)));
    window.body.join(placed(placement, ellipsoid("recess of the window", {0.40, 0.62, 0.66}, {0.20, 0.17, 0.19})),
                     0.06 * placement.scale);
    scenery.layers.push_back(std::move(window));

    PhantomLayer objects{.body = {}, .material = PhantomMaterial::object, .echo = config.object, .shadowing = 1.0};
    const auto place = [&](const ImplicitPrimitive& primitive) { objects.body.join(placed(placement, primitive)); };
    place(ellipsoid("ellipsoid", {0.34, 0.40, 0.47}, {0.19, 0.13, 0.12}, rotationZ(25) * rotationY(-15)));
    place(cylinder("cylinder", {0.50, 0.78, 0.42}, {0.76, 0.52, 0.56}, 0.062, 0.015));
    place(sphere("sphere 1", {0.66, 0.27, 0.40}, 0.085));
    place(sphere("sphere 2", {0.24, 0.70, 0.53}, 0.070));
    place(sphere("sphere 3", {0.56, 0.50, 0.34}, 0.045));
    place(sphere("sphere 4", {0.40, 0.22, 0.30}, 0.035));
    place(sphere("sphere 5", {0.70, 0.42, 0.62}, 0.060));
    place(sphere("sphere 6, within tissue", {0.91, 0.72, 0.45}, 0.055));
    scenery.layers.push_back(std::move(objects));
}

}  // namespace echolucent
