// The speckle reduction that keeps edges and membranes: a joint bilateral filter on the speckle's own scale.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "processing/progress.h"
#include "processing/speckle_reduction/filter_slabs.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// One pass: each voxel becomes the mean of the voxels around it, weighted by how near they are and by how like.
/// Lengths are mean voxels (filterSpacing()).
struct JointBilateralPass {
    double guideSigma = 1.0;  ///< standard deviation of the Gaussian that makes the guide, above 0
    double spreads = 5.0;  ///< voxels whose guides differ by this many standard deviations of the guide's own speckle
                           ///< (SpeckleLaw) or more have no part; above 0
    double radius = 3.0;   ///< how far voxels that take part are away, at most; above 0
    double sigma = 2.0;    ///< standard deviation of the weight by distance, above 0
};

/// The volume after these passes. What is alike is judged on a guide, the Gaussian-smoothed volume (Petschnigg et al.
/// 2004; Eisemann and Durand 2004), by Tukey's biweight (Black et al. 1998), on a scale on which the guide's speckle is
/// equally strong everywhere: so that the mean of a membrane is taken within it, bright or dark. Whole numbers are
/// rounded after the last pass only. The rest is as quietVolume() says. Throws std::invalid_argument for a pass that
/// makes no sense, and where there is none. Volumes of more than `mostVoxels` pass slab by slab (filterSlabs()): beside
/// the result, that takes some 16 bytes for each voxel of a slab and of what it reaches, up to 12 for each voxel of a
/// slice and thread, and, where there are several passes, 4 for each voxel of the volume.
[[nodiscard]] std::optional<Volume> jointBilateralFiltered(const Volume& volume,
                                                           std::span<const JointBilateralPass> passes,
                                                           const Progress& progress = {},
                                                           std::int64_t mostVoxels = mostVoxelsAtOnce);

}  // namespace echolucent
