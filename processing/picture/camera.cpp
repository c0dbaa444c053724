#include "processing/picture/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<2> projectionNames{"parallel", "perspective"};
}

std::string_view nameOf(Projection projection) { return nameIn(projectionNames, projection); }

std::optional<Projection> projectionFromName(std::string_view name) {
    return choiceNamed<Projection>(projectionNames, name);
}

Camera defaultCamera(const DataBox& box, const Viewpoint& view, double aspect) {
    if (!(aspect > 0.0) || !std::isfinite(aspect)) throw std::invalid_argument("defaultCamera: aspect must be above 0");
    constexpr double margin = 1.04;
    Camera camera;
    const OrientedBox fitted = view.box.value_or(orientedBoxOf(box));
    camera.focalPoint = fitted.centreMm;
    camera.frame = frameOf(view);
    camera.heightMm =
        margin * std::max(fitted.extentAlong(camera.frame.down), fitted.extentAlong(camera.frame.right) / aspect);
    const double halfAngle = camera.viewAngleDegrees * 0.5 * std::numbers::pi / 180.0;
    camera.distanceMm = camera.heightMm * 0.5 / std::tan(halfAngle) + fitted.extentAlong(camera.frame.forward) * 0.5;
    return camera;
}

}  // namespace echolucent
