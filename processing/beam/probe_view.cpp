#include "processing/beam/probe_view.h"

#include <cmath>

namespace echolucent {

namespace {

BeamAxis axisNearest(const Vec3& forward) {
    int nearest = 2;
    for (const int axis : {1, 0})
        if (std::abs(forward[axis]) > std::abs(forward[nearest])) nearest = axis;
    return static_cast<BeamAxis>(2 * nearest + (forward[nearest] > 0 ? 0 : 1));
}

double withoutRounding(double degrees) { return std::abs(degrees) < 1e-6 ? 0.0 : degrees; }

}  // namespace

Viewpoint viewFromProbe(const StatedProbe& probe) {
    Viewpoint view = viewAlong(probe.forward, probe.down, axisNearest(probe.forward));
    view.azimuthDegrees = withoutRounding(view.azimuthDegrees);
    view.elevationDegrees = withoutRounding(view.elevationDegrees);
    view.rollDegrees = withoutRounding(view.rollDegrees);
    return view;
}

}  // namespace echolucent
