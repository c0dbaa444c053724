// The semi-automatic OTF of Kindlmann and Durkin (1998): opacity by where a voxel lies within a boundary.
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/gradients/kindlmann_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Its table, which also knows what is wrong with the nodes that were drawn; the argument only selects it.
[[nodiscard]] const ParameterTable<KindlmannConfig>& parametersOf(const KindlmannConfig&);

/// The boundary emphasis function b of a position, standard deviations of the boundary: the opacity, [0,1].
[[nodiscard]] double emphasisAt(const KindlmannConfig& config, double position);

/// Opacity is b of the position in boundaries (boundaryPositions()), and 0 where no position is known. The derivatives
/// are those of input.shown. One dimension gives a SampledCurve of 256 nodes, two a TwoDimensionalOtf of 256 x 64.
/// Facts: the boundary's width with and without the prefilter, the extremes of the mean derivatives, the share of the
/// voxels with data that count. Plots: mean derivatives and position over the intensity.
/// Where no boundary is found, where what is found is speckle or thin layers
/// (BoundaryWidth::isSharperThanBoundaries()), or where b leaves nothing of it, x^2 is given and the message says so.
/// The result is empty only where progress.cancel was raised, and has the same bits for any number of threads. Throws
/// std::invalid_argument where problemIn(parametersOf(config), config) is not empty or where the volumes have different
/// grids.
[[nodiscard]] std::optional<Design> design(const KindlmannConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
