// A joint bilateral filter on the speckle's own scale: the speckle reduction that keeps edges and membranes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "processing/progress.h"
#include "processing/speckle_reduction/filter_slabs.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// One pass. Each voxel becomes the mean of the voxels around it, weighted by nearness and likeness. Lengths are given
/// in mean edges of a voxel (filterSpacing()).
struct JointBilateralPass {
    double guideSigma = 1.0;  ///< standard deviation of the Gaussian that makes the guide, above 0
    double spreads = 5.0;     ///< voxels take no part if their guides differ by this many standard deviations of the
                              ///< guide's own speckle (SpeckleLaw) or more; above 0
    double radius = 3.0;      ///< the largest distance of voxels that take part; above 0
    double sigma = 2.0;       ///< standard deviation of the weight by distance, above 0
};

/// The volume after these passes. A guide, the Gaussian-smoothed volume (Petschnigg et al. 2004; Eisemann and Durand
/// 2004), decides which voxels are alike. The weight of likeness is Tukey's biweight (Black et al. 1998), on a scale on
/// which the guide's speckle is equally strong everywhere. So the mean of a membrane is taken within it, bright or
/// dark. Whole numbers are rounded after the last pass only. Otherwise as quietVolume(). Throws std::invalid_argument
/// if there is no pass, or if a value of a pass is not above 0. Volumes of more than `mostVoxels` are filtered slab by
/// slab (filterSlabs()). Memory beside the result: some 16 bytes for each voxel of a slab and its reach, up to 12 for
/// each voxel of a slice and thread. Two passes take 4 bytes more for each voxel of the volume, three or more passes 8.
[[nodiscard]] std::optional<Volume> jointBilateralFiltered(const Volume& volume,
                                                           std::span<const JointBilateralPass> passes,
                                                           const Progress& progress = {},
                                                           std::int64_t mostVoxels = mostVoxelsAtOnce);

}  // namespace echolucent
