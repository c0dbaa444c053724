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

}  // namespace

Viewpoint viewFromProbe(const StatedProbe& probe) {
    return withoutRounding(viewAlong(probe.forward, probe.down, axisNearest(probe.forward)));
}

}  // namespace echolucent
