// The stages of the adaptive OTF as one would write them with OpenCV: a contender to measure beside it.
#pragma once

#include <memory>

#include "processing/adaptive/adaptive_otf.h"

namespace echolucent::bench {

/// The stages written with OpenCV as one would without knowing this program: cv::boxFilter and cv::sqrBoxFilter over
/// slices where the tubes lie on voxels of slices, else trilinear interpolation sample by sample and cv::reduce; then
/// one row of a matrix a tube core and cv::boxFilter, cv::log, cv::filter2D, cv::sort and cv::exp on those.
class OpenCvOtf {
public:
    OpenCvOtf(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config);
    /// Runs all stages once, and returns the curve's sum.
    [[nodiscard]] double run();
    /// The largest difference between its cell means and those of the method, normalised intensity.
    [[nodiscard]] double differenceTo(const AdaptiveOtf& otf) const;

private:
    struct Stages;
    std::shared_ptr<Stages> m_stages;
};

}  // namespace echolucent::bench
