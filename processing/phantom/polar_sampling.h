// Simulated scenes along the beams of a polar volume.
#pragma once

#include "processing/phantom/phantom_scene.h"
#include "processing/scan_conversion/conversion_grid.h"

namespace echolucent {

/// The sampling at the samples of a polar volume, in grid mm of the grid that the volume is converted to. Lines run
/// fastest, then planes. Samples run along the beam.
[[nodiscard]] PhantomSampling polarSampling(const PolarGeometry& polar, const ConversionGrid& grid);

/// The usual probe of a kind, with `samples` along its beams, `stepMm` apart. Its field is about as wide as deep.
/// Commands take it if a person names no more than the kind.
[[nodiscard]] EvenPolar usualPolar(PolarKind kind, std::int64_t samples, double stepMm);

}  // namespace echolucent
