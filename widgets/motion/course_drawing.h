// What the map and the curves of a motion's OTFs both draw.
#pragma once

#include <QPainter>
#include <QString>

#include "widgets/motion/otf_course.h"
#include "widgets/otf_editor/plot_axes.h"
#include "widgets/otf_editor/plot_colours.h"

namespace echolucent {

inline constexpr double legendGap = 16.0;  ///< pixels between the map and its legend
inline constexpr double markWidth = 6.0;   ///< of the marks beside the map's present row

/// The colour of the line of the first, the middle or the last row (`place` 0, 1, 2). Beside their colours the three
/// lines differ in their dashes. The contrast with the plot's ground is at least 3 : 1.
[[nodiscard]] QColor fixedRowColour(std::size_t place, Theme theme);

/// "+3°", "−3°", "0°" for an angle, "volume 3" for a phase.
[[nodiscard]] QString rowName(const OtfCourse& course, int row);

/// The left and right ends of the plots of map and curves, so that their intensities lie above each other. In pixels
/// from the canvas's left and right end.
[[nodiscard]] double plotLeft(const QFontMetrics& metrics);
[[nodiscard]] double plotRight(const QFontMetrics& metrics);

/// The width of the map's legend, in which a word stands upright.
[[nodiscard]] double legendWidth(const QFontMetrics& metrics);

/// Ticks below the plot.
void paintIntensityTicks(QPainter& painter, const PlotAxes& axes, const PlotColours& colours);
/// Ticks and numbers below the plot, and the word "intensity".
void paintIntensityAxis(QPainter& painter, const PlotAxes& axes, const PlotColours& colours);

}  // namespace echolucent
