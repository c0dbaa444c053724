// An explanation as plots: Figs. 2, 4, 5 and 6 of Petersch et al. 2005 for one tube core. The window and the page draw
// the same values.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "processing/explanation/tube_explanation.h"
#include "processing/explanation/tube_factors.h"
#include "processing/plots/plot.h"

namespace echolucent {

/// Fig. 2: intensities along the tube core and the means of its cells, over units from its first sample. A cell stands
/// at its middle. The surface, I_L and I_H are marked, with the cells that they were read from as bands.
[[nodiscard]] Plot intensityProfilePlot(const TubeExplanation& explanation);

/// Fig. 4: the interface function over the same units. With VarianceRule at every scale, with the maximum found and,
/// above the curves, the ranges searched, coarsest on top. With RatioRule the contrast of every boundary, with the
/// least contrast that counts.
[[nodiscard]] Plot interfaceFunctionPlot(const TubeExplanation& explanation);

/// Eqs. 9 and 10: the histogram of all tube cores with a surface, relative to its fullest bin, and the weight that
/// follows from it, with this tube core's place. First by the largest prior mean, then by the slope.
[[nodiscard]] std::array<Plot, 2> rankPlots(const TubeExplanation& explanation);

/// Fig. 5: the factors, or ramps, of all tube cores that allFactors() gave, and heavy among them this one's.
[[nodiscard]] Plot factorsPlot(const TubeExplanation& explanation, std::span<const TubeFactor> all);

/// Fig. 6: the initial function, the run's curve, the curve without this tube core, and that of it alone.
[[nodiscard]] Plot curvesPlot(const TubeExplanation& explanation);

/// What the curve without this tube core differs by from the run's. One of many tube cores changes it little.
[[nodiscard]] Plot curveChangePlot(const TubeExplanation& explanation);

/// A grownCurve() as one more line of curvesPlot(): made of the first `count` of `all` tube cores.
[[nodiscard]] PlotSeries grownSeries(const SampledCurve& curve, std::size_t count, std::size_t all);

}  // namespace echolucent
