// What `bench otf` compares the adaptive OTF with: touching the voxels it needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent::cli {

/// The tube cores' samples of a view, row-major, as the method takes them.
[[nodiscard]] std::vector<TubeSamples> samplesOfTubes(const Volume& volume, const Viewpoint& view,
                                                      const AdaptiveOtfConfig& config);

/// Reads what the method must read and does nothing with it but add it up. Where the tubes lie on voxels these are all
/// voxels of every row of the array (along x) that holds a sample. Elsewhere it is one voxel a sample, at
/// floor(position), in the order in which the method takes the samples.
class Touch {
public:
    Touch(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config);
    /// Returns the sum, so that nothing is optimised away.
    [[nodiscard]] double run() const;

private:
    const Volume& m_volume;
    int m_columns;
    std::vector<TubeSamples> m_tubes;
    std::vector<std::size_t> m_rows;  ///< offsets of the rows; empty where the tubes do not lie on voxels
};

}  // namespace echolucent::cli
