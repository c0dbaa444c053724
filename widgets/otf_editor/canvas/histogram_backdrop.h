// The intensities of the volume, quiet behind the curves.
#pragma once

#include <QColor>
#include <QPainter>
#include <array>

#include "processing/intensity/histogram.h"
#include "widgets/otf_editor/canvas/plot_axes.h"

namespace echolucent {

/// How counts become heights.
enum class HistogramScale { linear, logarithmic };

/// Height of each bin as a share of the plot, [0,1]. The reference is the fullest bin between the first and the last
/// (saturated voxels and fluid at exactly 0 would flatten all others; their bins are cut at 1); logarithmic heights
/// are log(1 + count) / log(1 + reference).
[[nodiscard]] std::array<double, 256> histogramHeights(const IntensityHistogram& histogram, HistogramScale scale);

/// Fills the steps of the histogram over the shown intensities; the opacity axis's zoom does not touch the heights.
void paintHistogram(QPainter& painter, const PlotAxes& axes, const std::array<double, 256>& heights, const QColor& fill,
                    const QColor& outline);

}  // namespace echolucent
