// Why a picture is empty: a curve that leaves all data clear says so in place of a black picture.
#pragma once

#include <string>

#include "processing/intensity/histogram.h"
#include "processing/opacity_curve.h"

namespace echolucent {

/// Whether the curve shows nothing of these voxels. It is next to 0, below 2e-5 per unit, at every intensity from the
/// lowest to the highest of the data (between them too, because samples are interpolated): 200 units of it stay below
/// one level of 255. True where there is no data.
[[nodiscard]] bool showsNothing(const OpacityCurve& curve, const IntensityHistogram& data);

/// A sentence where the curve shows nothing of these voxels: what happened and what to do; else an empty text.
[[nodiscard]] std::string whyNothingShows(const OpacityCurve& curve, const IntensityHistogram& data);

}  // namespace echolucent
