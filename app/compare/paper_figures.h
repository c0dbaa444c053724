// Comparisons that one click sets up: figures of Petersch 2005, and a motion's OTFs side by side.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>
#include <span>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// A figure of the paper that one click sets up, on any study.
struct PaperFigure {
    int number = 0;
    const char* subject = "";  ///< in the paper's words, untranslated: subjectOf()
    const char* dock = "";     ///< object name of the dock that comes to the front; empty: none
    /// The frames of the motion, degrees, that are shown one after the other once the figure is set up. The last one is
    /// the angle of the document.
    std::vector<int> frames{};
};

/// Figures 1, 5, 6, 9, 10 and 11.
[[nodiscard]] std::span<const PaperFigure> paperFigures();
/// Throws std::invalid_argument if no figure has this number.
[[nodiscard]] const PaperFigure& paperFigure(int number);
[[nodiscard]] QString subjectOf(const PaperFigure& figure);

/// The document that shows a figure. It begins in one state, whatever the document was: one pane with the adaptive
/// curve, the light and look of a first start, the method's defaults, a motion at rest, and no adjustment of curves.
/// It keeps the study with all that belongs to it: beam, pose, side, front, exposure, box, planes, strokes, phase and
/// measurements. It also keeps the curves that a person has drawn or set. Then
///   1   has panes with (a) a linear OTF, (b) the piecewise linear one of eq. 1 with L_L = 20, a = 0.5, L_H = 255, (c)
///       the adaptive one;
///   5   has the method as published, whose curve is a product of basis functions;
///   6   has the same, and beside its curve the initial one, x² with the scale 1, and the piecewise linear one of (b);
///       this is the only figure that sets a curve which a person may have set;
///   9   turns the view by figure9Degrees: one pane has one OTF for all frames, the other an OTF for each frame;
///   10  has an OTF for each frame;
///   11  has panes with the mean of five OTFs and with an OTF for each frame, at figure11Degrees.
/// Throws std::invalid_argument if no figure has this number.
[[nodiscard]] Document withFigure(Document document, int number);
inline constexpr double figure9Degrees = 30.0;
/// How far the view turns in figure 11.
inline constexpr double figure11Degrees = 20.0;

/// The name of a pane. In figure 1, as long as nothing bends its curves, it is the paper's for the curve: "(a) Linear
/// OTF", "(b) Manually designed piecewise linear OTF", "(c) Adaptively designed OTF". Else it is nameOfPane(), with the
/// motion's OTF if another pane has one of its own.
[[nodiscard]] QString captionOfPane(const Document& document, std::size_t place);
/// captionOfPane() of each pane.
[[nodiscard]] QStringList captionsOfPanes(const Document& document);

/// The adaptive curve in three panes, for any motion: one OTF for all frames, an OTF for each frame, and an OTF for
/// each frame that is smoothed for the least flicker.
[[nodiscard]] Document motionSideBySide(Document document);

}  // namespace echolucent
