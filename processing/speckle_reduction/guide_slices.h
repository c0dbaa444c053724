// The input of a joint bilateral filter: a volume's intensities, and a guide that tells which voxels are alike.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/progress.h"
#include "processing/speckle_reduction/gaussian_filter.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Makes a few slices of both at a time. Its memory is kept from one make() to the next.
class GuideSlices {
public:
    /// The volume must outlive this object. `sigma` is the Gaussian's standard deviation (gaussianFiltered()). Throws
    /// std::invalid_argument if `sigma` is not above 0.
    GuideSlices(const Volume& volume, double sigma);

    /// Makes slices [first, end). False if cancelled.
    [[nodiscard]] bool make(std::int64_t first, std::int64_t end, const Progress& progress);
    /// Slice z of those that make() made last: normalised intensities, x fastest, 0 for no data. They are clamped into
    /// [0,1], so that very large or small stored values stay within the range of a float.
    [[nodiscard]] const float* intensities(std::int64_t z) const { return m_held.data() + (z - m_firstHeld) * m_slice; }
    /// Slice z of intensities() under the Gaussian; 0 for no data. Only for the slices [first, end) of make().
    [[nodiscard]] const float* guide(std::int64_t z) const { return m_guide.data() + (z - m_first) * m_slice; }
    /// The guide of the slices that make() made last, as a volume of white level 1, with the mask of these slices. It
    /// is valid until make() runs again, and no longer than this object and the volume live.
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
