#include "processing/scene/box.h"

#include <cmath>

namespace echolucent {

OrientedBox orientedBoxOf(const Box& box, BeamAxis beam) {
    return {box.centreMm, frameOf(viewpointOf(beam, box.direction)), box.sizeMm};
}

Box wholeBox(const Box& box, BeamAxis beam, const DataBox& data) {
    Box whole = box;
    whole.on = true;
    whole.centreMm = data.centreMm();
    const ViewFrame axes = frameOf(viewpointOf(beam, box.direction));
    const OrientedBox around = orientedBoxOf(data);
    whole.sizeMm = {around.extentAlong(axes.right), around.extentAlong(axes.down), around.extentAlong(axes.forward)};
    return whole;
}

std::string problemOf(const Box& box) {
    const bool neverSet = !box.on && box.sizeMm == Vec3(0, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(box.centreMm[axis])) return "has a centre that is not finite";
        if (!std::isfinite(box.sizeMm[axis]) || !(box.sizeMm[axis] > 0.0 || neverSet))
            return "has a size that is not above 0";
    }
    return {};
}

}  // namespace echolucent
