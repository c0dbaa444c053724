// The cheapest speckle reduction: a Gaussian.
#pragma once

#include <cstdint>
#include <memory>
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

/// Does the same to normalised intensities, a few slices at a time, in memory that is used again.
class GaussianSlices {
public:
    /// `mask` holds one byte a voxel of the whole grid, x fastest, 0 where there is no data; it is null where all is
    /// data, and must outlive this. `sigma` is as in gaussianFiltered(). Throws std::invalid_argument where that is not
    /// above 0.
    GaussianSlices(const VolumeGeometry& geometry, const std::uint8_t* mask, double sigma);
    ~GaussianSlices();
    GaussianSlices(const GaussianSlices&) = delete;
    GaussianSlices& operator=(const GaussianSlices&) = delete;

    /// How many slices away a voxel lies, at most, that has a part in a mean.
    [[nodiscard]] std::int64_t reach() const;
    /// Writes slices [first, end) of the grid to `results`, which has room for them, x fastest. `held` are intensities
    /// in [0,1] from slice `firstHeld` on, as far as the slices asked for reach within the grid; they stay as they are
    /// where there is no data. False where the run was cancelled, which leaves some results unwritten.
    [[nodiscard]] bool make(const float* held, std::int64_t firstHeld, std::int64_t first, std::int64_t end,
                            float* results, const Progress& progress);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
