// What the map and the curves of a motion's OTFs draw in common.
#pragma once

#include <QColor>
#include <QPainter>
#include <QPalette>
#include <QString>

#include "widgets/motion/otf_course.h"
#include "widgets/otf_editor/plot_axes.h"

namespace echolucent {

struct PlotColours {
    QColor background, text, secondary, grid, frame;
};
/// Of a plot that lies a little deeper than its panel, in the dark and in the light theme.
[[nodiscard]] PlotColours plotColours(const QPalette& palette);

/// "+3°", "−3°", "0°" for an angle, "phase 3" for a phase.
[[nodiscard]] QString rowName(const OtfCourse& course, int row);

/// Ticks and numbers below the plot, and the word "intensity".
void paintIntensityAxis(QPainter& painter, const PlotAxes& axes, const PlotColours& colours);

}  // namespace echolucent
