// The histogram of the volume, faint behind the curves.
#pragma once

#include <QColor>
#include <QPainter>
#include <array>

#include "processing/intensity/histogram.h"
#include "widgets/otf_editor/plot_axes.h"

namespace echolucent {

/// How counts become heights.
enum class HistogramScale { linear, logarithmic };

/// Height of each bin as a share of the plot, [0,1]. The reference is the fullest bin, the first and the last left out:
/// saturated voxels and fluid at exactly 0 would flatten all others. These two bins are cut at 1. If all other bins are
/// empty, the fuller of the two is the reference. Logarithmic heights are log(1 + count) / log(1 + reference).
[[nodiscard]] std::array<double, 256> histogramHeights(const IntensityHistogram& histogram, HistogramScale scale);

/// Fills the histogram's steps over the shown intensities. The zoom of the opacity axis does not change heights.
void paintHistogram(QPainter& painter, const PlotAxes& axes, const std::array<double, 256>& heights, const QColor& fill,
                    const QColor& outline);

}  // namespace echolucent
