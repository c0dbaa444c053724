// The semi-automatic OTF of Kindlmann and Durkin (1998): opacity by where a voxel lies within a boundary.
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/gradients/kindlmann_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Its table, which also checks the drawn nodes; the argument only selects it.
[[nodiscard]] const ParameterTable<KindlmannConfig>& parametersOf(const KindlmannConfig&);

/// The boundary emphasis function b: the opacity, [0,1], at a position in standard deviations of the boundary.
[[nodiscard]] double emphasisAt(const KindlmannConfig& config, double position);

/// Opacity is b of the position in boundaries (boundaryPositions()), and 0 if no position is known. The derivatives are
/// those of input.shown. One dimension gives a SampledCurve of 256 nodes, two a TwoDimensionalOtf of 256 x 64.
/// Facts: the boundary's width with and without the prefilter, the extremes of the mean derivatives, the share of the
/// voxels with data that count. Plots: mean derivatives and position over the intensity.
/// The curve is x^2, and the message says so, in three cases: no boundary is found, the one found is speckle or thin
/// layers (BoundaryWidth::isSharperThanBoundaries()), or b leaves nothing of it.
/// The result is empty only if progress.cancel was raised. Its bits are the same for any number of threads. Throws
/// std::invalid_argument if problemIn(parametersOf(config), config) is not empty or the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const KindlmannConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
