// The voxels of a volume as a joint bilateral filter takes them: intensities, and the guide that says what is alike.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/progress.h"
#include "processing/speckle_reduction/gaussian_filter.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Makes a few slices of both at a time, in memory that is used again.
class GuideSlices {
public:
    /// The volume must outlive this; `sigma` is the Gaussian's standard deviation (gaussianFiltered()). Throws
    /// std::invalid_argument where that is not above 0.
    GuideSlices(const Volume& volume, double sigma);

    /// Makes slices [first, end). False where the run was cancelled.
    [[nodiscard]] bool make(std::int64_t first, std::int64_t end, const Progress& progress);
    /// Slice z of those that were made last: normalised intensities, x fastest; 0 where there is no data. What is above
    /// the white level is 1, what is below 0 is 0, so that neither very large nor very small stored values leave what a
    /// float can hold.
    [[nodiscard]] const float* intensities(std::int64_t z) const { return m_held.data() + (z - m_firstHeld) * m_slice; }
    /// The same slice under the Gaussian; 0 where there is no data.
    [[nodiscard]] const float* guide(std::int64_t z) const { return m_guide.data() + (z - m_first) * m_slice; }
    /// The guide of the slices that were made last as a volume, of white level 1, with the mask of these slices. It is
    /// valid until the next ones are made.
    [[nodiscard]] Volume guideVolume() const;

private:
    void readIntensities(std::int64_t first, std::int64_t end);

    const Volume& m_volume;
    std::int64_t m_slice;  ///< voxels of one slice
    GaussianSlices m_gaussian;
    std::array<float, 256> m_intensityOfByte{};
    std::vector<float> m_held, m_guide;
    std::int64_t m_firstHeld = 0, m_first = 0, m_end = 0;
};

}  // namespace echolucent
