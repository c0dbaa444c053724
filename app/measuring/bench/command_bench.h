// The yardstick of `bench otf` for the adaptive OTF: touching the voxels that it needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent::cli {

/// The samples of a view's tube cores, row-major, as the method reads them.
[[nodiscard]] std::vector<TubeSamples> samplesOfTubes(const Volume& volume, const Viewpoint& view,
                                                      const AdaptiveOtfConfig& config);

/// Reads the voxels that the method must read, and only adds them up. If the tube cores lie on voxels, these are all
/// voxels of every row of the array (along x) with a sample. Otherwise it is one voxel a sample, at floor(position), in
/// the method's order of samples.
class Touch {
public:
    Touch(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config);
    /// Returns the sum, so that the compiler removes nothing.
    [[nodiscard]] double run() const;

private:
    const Volume& m_volume;
    int m_columns;
    std::vector<TubeSamples> m_tubes;
    std::vector<std::size_t> m_rows;  ///< offsets of the rows; empty if the tube cores do not lie on voxels
};

}  // namespace echolucent::cli
