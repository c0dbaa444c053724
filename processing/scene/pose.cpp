#include "processing/scene/pose.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<5> beamSourceNames{"assumed", "sector shape", "echo", "person", "file"};

/// Height of the picture at magnification 1, mm.
double wholeBoxHeightMm(const DataBox& box, BeamAxis beam, double aspect) {
    return fittedPose(box, Viewpoint{.beamAxis = beam}, Projection::parallel, aspect).heightMm;
}

}  // namespace

std::string_view nameOf(BeamSource source) { return nameIn(beamSourceNames, source); }

std::optional<BeamSource> beamSourceFromName(std::string_view name) {
    return choiceNamed<BeamSource>(beamSourceNames, name);
}

Viewpoint viewpointOf(BeamAxis beam, const ViewDirection& direction) {
    return {beam, direction.azimuth, direction.elevation, direction.roll};
}

Viewpoint viewAlongBeam(const Beam& beam) { return viewpointOf(beam.axis, beam.lean); }

ViewDirection directionOf(const Viewpoint& viewpoint) {
    const Viewpoint within = withinPoles(viewpoint);
    return {within.azimuthDegrees, within.elevationDegrees, within.rollDegrees};
}

Pose turnedTo(const Pose& pose, BeamAxis beam, const ViewDirection& direction) {
    const ViewFrame before = frameOf(viewpointOf(beam, pose.direction));
    const ViewFrame after = frameOf(viewpointOf(beam, direction));
    Pose turned = pose;
    turned.direction = direction;
    turned.offsetMm = after.right * pose.offsetMm.dot(before.right) + after.down * pose.offsetMm.dot(before.down) +
                      after.forward * pose.offsetMm.dot(before.forward);
    return turned;
}

CameraPose cameraPoseOf(const Pose& pose, BeamAxis beam, const DataBox& box, Projection projection, double aspect) {
    return {viewpointOf(beam, pose.direction), box.centreMm() + pose.offsetMm,
            wholeBoxHeightMm(box, beam, aspect) / pose.magnification, projection};
}

Pose movedPose(const Pose& pose, const CameraPose& before, const CameraPose& after, const DataBox& box, double aspect) {
    Pose moved = pose;
    moved.direction = directionOf(after.view);
    if (after.focalPoint != before.focalPoint) moved.offsetMm = after.focalPoint - box.centreMm();
    if (after.heightMm != before.heightMm)
        moved.magnification = wholeBoxHeightMm(box, after.view.beamAxis, aspect) / after.heightMm;
    return moved;
}

Pose wholeVolumePose(const DataBox& box, const Viewpoint& viewpoint, Projection projection, double aspect) {
    const CameraPose fitted = fittedPose(box, viewpoint, projection, aspect);
    return {directionOf(viewpoint), fitted.focalPoint - box.centreMm(),
            wholeBoxHeightMm(box, viewpoint.beamAxis, aspect) / fitted.heightMm};
}

}  // namespace echolucent
