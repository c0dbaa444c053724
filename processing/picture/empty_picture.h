// Why a picture is empty. If a curve leaves all data clear, a sentence replaces the black picture.
#pragma once

#include <string>

#include "processing/intensity/histogram.h"
#include "processing/opacity_curve.h"

namespace echolucent {

/// Whether the curve shows nothing of these voxels. True if it stays below 2e-5 per unit at every intensity from the
/// lowest to the highest of the data. Intensities between count too, because samples are interpolated. 200 units of
/// such opacity make about one level of 255. True if there is no data.
[[nodiscard]] bool showsNothing(const OpacityCurve& curve, const IntensityHistogram& data);

/// What happened and what to do, as a sentence, if the curve shows nothing of these voxels. Else empty.
[[nodiscard]] std::string whyNothingShows(const OpacityCurve& curve, const IntensityHistogram& data);

}  // namespace echolucent
