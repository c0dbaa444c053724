// A Gaussian: the cheapest speckle reduction.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A Gaussian is cut at this many standard deviations.
inline constexpr double gaussianReach = 3.0;

/// The volume smoothed by a Gaussian of this standard deviation (mean voxels, see filterSpacing()), cut at
/// gaussianReach. It is a normalised convolution (Knutsson and Westin 1993): voxels without data, and places outside
/// the grid, have no weight. Throws std::invalid_argument if `sigma` is not above 0. Otherwise as quietVolume().
[[nodiscard]] std::optional<Volume> gaussianFiltered(const Volume& volume, double sigma, const Progress& progress = {});

/// The same filter for normalised intensities, a few slices at a time. Its memory is kept from call to call.
class GaussianSlices {
public:
    /// `mask` holds one byte a voxel of the whole grid, x fastest, 0 for no data. It is null if all voxels are data,
    /// and must outlive this object. `sigma` is as in gaussianFiltered(). Throws std::invalid_argument if `sigma` is
    /// not above 0.
    GaussianSlices(const VolumeGeometry& geometry, const std::uint8_t* mask, double sigma);
    ~GaussianSlices();
    GaussianSlices(const GaussianSlices&) = delete;
    GaussianSlices& operator=(const GaussianSlices&) = delete;

    /// The largest distance, in slices, of a voxel that takes part in a mean.
    [[nodiscard]] std::int64_t reach() const;
    /// Writes slices [first, end) of the grid to `results`, which has room for them, x fastest. `held` holds
    /// intensities in [0,1]: from slice `firstHeld` on, all slices of the grid within reach() of [first, end). Voxels
    /// without data keep their intensity. False if cancelled; some results are then unwritten.
    [[nodiscard]] bool make(const float* held, std::int64_t firstHeld, std::int64_t first, std::int64_t end,
                            float* results, const Progress& progress);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
