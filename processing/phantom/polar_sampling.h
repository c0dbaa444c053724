// A simulated scene looked at along the beams of a polar volume.
#pragma once

#include "processing/phantom/phantom_scene.h"
#include "processing/scan_conversion/conversion_grid.h"

namespace echolucent {

/// At the samples of a polar volume, in the grid mm of a grid that it is converted to. Lines run fastest, then planes;
/// samples run along the beam.
[[nodiscard]] PhantomSampling polarSampling(const PolarGeometry& polar, const ConversionGrid& grid);

/// A probe of that kind with `samples` along its beams, `stepMm` apart, whose field is about as wide as deep: where a
/// person does not say more of it.
[[nodiscard]] EvenPolar usualPolar(PolarKind kind, std::int64_t samples, double stepMm);

}  // namespace echolucent
