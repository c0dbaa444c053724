// The words of what a pane can be rendered with, as the panel of the comparison, captions and pages have them.
#pragma once

#include <QString>

#include "processing/adaptive/method_reading.h"
#include "processing/designers/choice/designer.h"
#include "processing/document/pane.h"

namespace echolucent {

/// "x² (parabolic curve)".
[[nodiscard]] QString labelOfCurve(CurveKind kind);
/// "Levoy", "Adaptive, as a designer".
[[nodiscard]] QString labelOfDesigner(Designer designer);
/// "mean of 5".
[[nodiscard]] QString wordsOf(MotionOtf otf);
/// "as published", "settled", "as in 0.1", "default".
[[nodiscard]] QString wordsOf(MethodReading reading);

/// "Piecewise linear curve (eq. 1)", "x² (parabolic curve)", "Levoy", "Adaptive without tube core 112", "Piecewise
/// linear curve of its own" if it is not that of eq. 1. With ", as published", ", settled", ", as in 0.1", ", default"
/// or ", own parameters" if the pane has a method of its own, with ", mean of 5" if it has an OTF of its own in a
/// motion, and with ", volume 3" if it has a phase of its own.
[[nodiscard]] QString nameOfPane(const Pane& choice);

}  // namespace echolucent
