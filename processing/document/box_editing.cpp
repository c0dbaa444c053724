#include "processing/document/box_editing.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

bool neverSet(const Box& box) { return box.sizeMm == Box{}.sizeMm; }

}  // namespace

Box movedBox(const Box& box, const OrientedBox& moved, BeamAxis beam) {
    Box next = box;
    next.centreMm = moved.centreMm;
    next.sizeMm = moved.sizeMm;
    if (moved.axes != orientedBoxOf(box, beam).axes)
        next.direction = directionOf(viewAlong(moved.axes.forward, moved.axes.down, beam));
    return next;
}

Document withBeam(Document document, const Beam& beam) {
    Box& box = document.scene.box;
    if (!neverSet(box)) {
        const ViewFrame axes = orientedBoxOf(box, document.beam.axis).axes;
        box.direction = directionOf(viewAlong(axes.forward, axes.down, beam.axis));
    }
    if (Front& front = document.scene.front; front.depthMm > 0.0) {
        const ViewFrame across = frameOf(viewpointOf(document.beam.axis, front.direction));
        front.direction = directionOf(viewAlong(across.forward, across.down, beam.axis));
    }
    document.scene.planes.direction = ViewDirection{};
    document.scene.planes.crops = {};
    document.beam = beam;
    return document;
}

Document withBoxSwitched(Document document, bool on, const DataBox& data) {
    Box box = document.scene.box;
    if (on && neverSet(box)) box = wholeBox(box, document.beam.axis, data);
    box.on = on;
    document.scene.box = box;
    return document;
}

Document withSlab(Document document, PlaneName plane, double thicknessMm, const DataBox& data) {
    const Planes& planes = document.scene.planes;
    const ViewFrame seen = frameOf(plane, planes, document.beam.axis);
    Box box{.on = true, .direction = {}};
    box.direction = directionOf(viewAlong(seen.forward, seen.down, document.beam.axis));
    box = wholeBox(box, document.beam.axis, data);
    const Vec3 forward = orientedBoxOf(box, document.beam.axis).axes.forward;
    box.centreMm += forward * forward.dot(referencePointOf(planes, data) - box.centreMm);
    box.sizeMm[2] = thicknessMm;
    Document next = std::move(document);
    next.scene.box = box;
    next.scene.side = box.direction;
    next.scene.motionAngle = 0.0;
    // A slab before the front would be cut away.
    next.scene.front = Front{};
    Pose& pose = next.scene.pose;
    pose = turnedTo(pose, next.beam.axis, next.scene.side);
    return next;
}

CutSurface surfaceOfFront(const Document& document, const Volume& volume) {
    const Front& front = document.scene.front;
    if (front.surface) return *front.surface;
    const BeamAxis beam = document.beam.axis;
    const Box& set = document.scene.box;
    const Viewpoint across = withFrontAcross(viewpointOf(beam, front.direction), front.depthMm);
    // The surface must cover this box.
    const OrientedBox place = orientedBoxOf(set.on ? set : wholeBox({}, beam, volume.dataBox()), beam);
    CutSurface surface;
    surface.frame = frameOf(across);
    constexpr int nodes = 33;
    const double width = place.extentAlong(surface.frame.right), height = place.extentAlong(surface.frame.down);
    surface.spacingMm = std::max(width, height) / (nodes - 1);
    const auto count = [&](double mm) { return std::max(2, static_cast<int>(std::ceil(mm / surface.spacingMm)) + 1); };
    surface.columns = count(width);
    surface.rows = count(height);
    surface.firstRightMm = surface.frame.right.dot(place.centreMm) - surface.spacingMm * (surface.columns - 1) / 2.0;
    surface.firstDownMm = surface.frame.down.dot(place.centreMm) - surface.spacingMm * (surface.rows - 1) / 2.0;
    const double depth = nearPlaneDepthMm(across, volume.geometry());
    const auto nodesInAll = static_cast<std::size_t>(surface.columns) * static_cast<std::size_t>(surface.rows);
    surface.depthMm = std::vector<float>(nodesInAll, static_cast<float>(depth));
    return surface;
}

double bowAt(const CutSurface& surface, const Vec3& gridMm) {
    const auto share = [](double mm, double first, double spacing, int count) {
        const double half = spacing * (count - 1) / 2.0, at = (mm - first - half) / half;
        return std::max(0.0, 1.0 - at * at);
    };
    return share(surface.frame.right.dot(gridMm), surface.firstRightMm, surface.spacingMm, surface.columns) *
           share(surface.frame.down.dot(gridMm), surface.firstDownMm, surface.spacingMm, surface.rows);
}

CutSurface bowed(CutSurface surface, double mm) {
    std::vector<float> depths = surface.depthMm;
    for (int row = 0; row < surface.rows; ++row)
        for (int column = 0; column < surface.columns; ++column) {
            const Vec3 place = surface.frame.right * (surface.firstRightMm + surface.spacingMm * column) +
                               surface.frame.down * (surface.firstDownMm + surface.spacingMm * row);
            float& depth = depths[static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.columns) +
                                  static_cast<std::size_t>(column)];
            depth += static_cast<float>(mm * bowAt(surface, place));
        }
    surface.depthMm = std::move(depths);
    return surface;
}

}  // namespace echolucent
