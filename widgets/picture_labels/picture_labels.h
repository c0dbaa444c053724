// What is written over a picture that leaves the window: the words and marks that the 3D view shows on the screen.
#pragma once

#include <QSize>
#include <QString>
#include <optional>

#include "processing/motion/motion_choice.h"
#include "processing/picture/camera.h"

class QPainter;

namespace echolucent {

/// The labels of one picture.
struct PictureLabels {
    QString caption{};  ///< what was done to the picture, one line each; it stands in the upper left corner
    QString frame{};    ///< which frame of a motion it is; it stands in the upper right corner
    Camera camera{};
    bool spacingKnown = true;  ///< else a sentence stands in the scale bar's place
};

/// "phase 7 of 20 · 183 ms" where the object moves, "+3°" where the probe does, and both where both do. The time is
/// that since the first phase of the study; without `phaseSeconds` none is told.
[[nodiscard]] QString frameWords(const MotionPosition& position, MotionScenario scenario, int phases,
                                 std::optional<double> phaseSeconds);

/// Paints the labels over a picture that lies at the painter's origin and is as large as said, in the painter's units:
/// caption and frame above, the orientation marker and the scale bar below, where the 3D view has them. `scale` is the
/// number of units in a pixel of a plain screen, above 0. Works in any thread that may paint on the painter's device.
void paintLabels(QPainter& painter, const QSize& picture, const PictureLabels& labels, double scale = 1.0);

}  // namespace echolucent
