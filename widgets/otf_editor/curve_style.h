// One look per curve, everywhere: colour and line style, so that no meaning rests on colour alone.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPen>
#include <QSize>
#include <QString>

#include "widgets/otf_editor/otf_editor_state.h"
#include "widgets/theme_colours.h"

namespace echolucent {

/// The part of object names that stands for a kind: "adaptive", "manual", "linear", "parabolic", "quartic".
[[nodiscard]] QString curveKey(CurveKind kind);
/// The name in a legend: "Adaptive", "Manual", "Linear (eq. 1)", "x²", "x⁴".
[[nodiscard]] QString curveShortName(CurveKind kind);
/// The name in a sentence: "adaptive", "manual", "piecewise linear", "parabolic", "quartic".
[[nodiscard]] QString curveName(CurveKind kind);

/// The curve's one colour. It has a contrast of at least 3 : 1 on plots and panels of the theme (WCAG 2.1, 1.4.11).
/// Reports use the same colours.
[[nodiscard]] QColor curveColor(CurveKind kind, Theme theme);
/// Colour, width and dashes; the active curve is drawn heavier.
[[nodiscard]] QPen curvePen(CurveKind kind, bool active, Theme theme);
/// Colour and pen of a designer's upper curve. Its colour and its dashes differ from those of the five curves.
[[nodiscard]] QColor designColor(Theme theme);
[[nodiscard]] QPen designPen(Theme theme);
inline constexpr QSize curveSampleSize{25, 12};  ///< pixels
/// A short piece of the line, with a square node for the manual curve.
[[nodiscard]] QIcon curveSample(CurveKind kind, Theme theme);
/// A short piece of the line of a designer's upper curve.
[[nodiscard]] QIcon designSample(Theme theme);

/// The square of a manual curve's node around `centre`; `side` in pixels.
void paintNode(QPainter& painter, QPointF centre, double side, const QColor& fill, const QColor& outline);

/// An arrow bent to the left (undo) or to the right (redo).
[[nodiscard]] QIcon bentArrowIcon(bool toTheLeft, const QColor& color, const QColor& disabledColor);

}  // namespace echolucent
