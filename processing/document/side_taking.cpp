#include "processing/document/side_taking.h"

#include <cmath>
#include <utility>

namespace echolucent {

Front frontOf(const Viewpoint& view, const NearCutFinding& finding) {
    if (!makesFront(finding)) return {};
    if (finding.surface) return Front{.surface = finding.surface, .source = FrontSource::found};
    return frontAcross(directionOf(view), std::round(10 * finding.nearCutMm) / 10, FrontSource::found);
}

Document withSideTaken(Document document, const JudgedSide& judged, const DataBox& box, double aspect) {
    Scene& scene = document.scene;
    scene.side = directionOf(judged.side.view);
    scene.front = frontOf(judged.side.view, judged.front);
    scene.exposure = judged.exposure;
    scene.motionAngle = 0.0;
    Viewpoint shown = judged.side.view;
    if (scene.box.on) shown.box = orientedBoxOf(scene.box, document.beam.axis);
    scene.pose = wholeVolumePose(box, shown, scene.look.projection, aspect);
    return document;
}

std::optional<std::size_t> sideAlong(const SidesFinding& sides, BeamAxis axis, const ViewDirection& direction) {
    constexpr double leastCosine = 0.9998;  // a degree
    const Vec3 forward = frameOf(viewpointOf(axis, direction)).forward;
    for (std::size_t i = 0; i < sides.sides.size(); ++i)
        if (frameOf(sides.sides[i].side.view).forward.dot(forward) > leastCosine) return i;
    return std::nullopt;
}

}  // namespace echolucent
