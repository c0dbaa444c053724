// The light that is held back early, as bars along the intensity axis of a plot.
#pragma once

#include <QColor>
#include <QPainter>
#include <QString>
#include <array>

#include "processing/comparison/early_light.h"
#include "widgets/otf_editor/plot_axes.h"

namespace echolucent {

/// A bar as high as the plot is this share of the light: the least of 0.1, 0.2, 0.5 and 1 that holds all bars. So haze
/// is seen to grow and to vanish, and no bar is cut.
[[nodiscard]] double earlyLightOfFullHeight(const EarlyLight& light);
/// Height of each bar as a share of the plot, [0,1].
[[nodiscard]] std::array<double, EarlyLight::bins> earlyLightHeights(const EarlyLight& light);
/// "Held back early: 31 % of the light, height: 20 %", "Held back early: none of the light", "No surface is known in
/// this view".
[[nodiscard]] QString wordsOf(const EarlyLight& light);
/// Fills the bars over the shown intensities, with rising lines as colours over pictures have them. The zoom of the
/// opacity axis does not change heights.
void paintEarlyLight(QPainter& painter, const PlotAxes& axes, const EarlyLight& light, const QColor& colour);

}  // namespace echolucent
