// Comparisons that one click sets up: figures 1 and 9 of Petersch 2005, and a motion's OTFs side by side.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>

#include "processing/document/document.h"

namespace echolucent {

/// Figure 1: (a) a linear OTF, (b) the piecewise linear one of eq. 1 with L_L = 20, a = 0.5, L_H = 255, (c) the
/// adaptive one. The manual curve becomes that of (a).
[[nodiscard]] Document figure1(Document document);

/// The name of a pane. In figure1(), as long as nothing bends its curves, it is the paper's for the curve: "(a) Linear
/// OTF", "(b) Manually designed piecewise linear OTF", "(c) Adaptively designed OTF". Else it is nameOfPane().
[[nodiscard]] QString captionOfPane(const Document& document, std::size_t place);
/// captionOfPane() of each pane.
[[nodiscard]] QStringList captionsOfPanes(const Document& document);

/// Figure 9 shows the frame of a motion that is figure9Degrees from its first view; the caller turns the motion there.
/// One pane has one OTF for all frames, the other an OTF for each frame. The motion itself shows one OTF.
[[nodiscard]] Document figure9(Document document);
inline constexpr double figure9Degrees = 30.0;

/// The adaptive curve in three panes, for any motion: one OTF for all frames, an OTF for each frame, and an OTF for
/// each frame that is smoothed for the least flicker.
[[nodiscard]] Document motionSideBySide(Document document);

}  // namespace echolucent
