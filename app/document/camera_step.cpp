#include "app/document/camera_step.h"

#include <QCoreApplication>
#include <utility>

namespace echolucent {

CameraStep cameraStep(Document document, const Pose& moved) {
    const Pose shown = shownPose(document);
    const char* what = moved.direction != shown.direction           ? QT_TRANSLATE_NOOP("camera", "turn view")
                       : moved.magnification != shown.magnification ? QT_TRANSLATE_NOOP("camera", "zoom")
                                                                    : QT_TRANSLATE_NOOP("camera", "move view");
    document.scene.pose = moved;
    document.scene.motionAngle = 0.0;
    return {std::move(document), QCoreApplication::translate("camera", what)};
}

}  // namespace echolucent
