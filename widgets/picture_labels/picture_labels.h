// The words and marks over a picture that leaves the window: those that the 3D view shows on the screen.
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
    bool spacingKnown = true;  ///< if false, a sentence replaces the scale bar
};

/// "volume 7 of 20 · 183 ms" if the object moves, "+3°" if the probe does, both if both do. The time is counted from
/// the study's first phase, and missing if it is unknown.
[[nodiscard]] QString frameWords(const MotionPosition& position, MotionScenario scenario, int phases,
                                 const PhaseTimes& times);

/// Paints the labels over a picture at the painter's origin: caption and frame above, the orientation marker and the
/// scale bar below, as in the 3D view. `picture` is its size in the painter's units. `scale` is the number of units in
/// a pixel of a plain screen, above 0. Works in any thread that may paint on the device.
void paintLabels(QPainter& painter, const QSize& picture, const PictureLabels& labels, double scale = 1.0);

}  // namespace echolucent
