#include "processing/scene/box.h"

#include <cmath>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<6> boxSideNames{"top", "bottom", "left", "right", "near", "far"};

ViewFrame looking(const Vec3& forward, const Vec3& down) { return {down.cross(forward), down, forward}; }

}  // namespace

std::string_view nameOf(BoxSide side) { return nameIn(boxSideNames, side); }

std::optional<BoxSide> boxSideFromName(std::string_view name) { return choiceNamed<BoxSide>(boxSideNames, name); }

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

ViewFrame frameFrom(BoxSide side, const ViewFrame& boxAxes) {
    switch (side) {
        case BoxSide::top: return boxAxes;
        case BoxSide::bottom: return looking(-boxAxes.forward, boxAxes.down);
        case BoxSide::left: return looking(boxAxes.right, boxAxes.forward);
        case BoxSide::right: return looking(-boxAxes.right, boxAxes.forward);
        case BoxSide::near: return looking(-boxAxes.down, boxAxes.forward);
        case BoxSide::far: return looking(boxAxes.down, boxAxes.forward);
    }
    return boxAxes;
}

ViewDirection directionFrom(BoxSide side, const Box& box, BeamAxis beam) {
    if (side == BoxSide::top) return box.direction;  // to the bit; the way through a frame is not exact
    const ViewFrame frame = frameFrom(side, frameOf(viewpointOf(beam, box.direction)));
    return directionOf(viewAlong(frame.forward, frame.down, beam));
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
