// The step of the document that the hand makes when it moves a camera.
#pragma once

#include <QString>

#include "processing/document/document.h"

namespace echolucent {

/// The document with a camera that was moved, and what the step is called.
struct CameraStep {
    Document next;
    QString what;
};
/// The view looks from `moved`. A motion starts anew from there, where the person left the camera.
[[nodiscard]] CameraStep cameraStep(Document document, const Pose& moved);

}  // namespace echolucent
