// The cheapest speckle reduction: a Gaussian.
#pragma once

#include <optional>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A Gaussian is cut at so many standard deviations.
inline constexpr double gaussianReach = 3.0;

/// The volume smoothed by a Gaussian of this standard deviation (mean voxels, see filterSpacing(); above 0), cut at
/// gaussianReach. It is a normalised convolution: voxels without data, and what lies outside the grid, have no weight
/// (Knutsson and Westin 1993). The rest is as quietVolume() says.
[[nodiscard]] std::optional<Volume> gaussianFiltered(const Volume& volume, double sigma, const Progress& progress = {});

}  // namespace echolucent
