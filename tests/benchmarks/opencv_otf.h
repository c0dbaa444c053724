// The stages of the adaptive OTF written with OpenCV: a contender for the program's own.
#pragma once

#include <memory>

#include "processing/adaptive/adaptive_otf.h"

namespace echolucent::bench {

/// The stages as one would write them without knowing this program. If the tubes lie on voxels of slices, cv::boxFilter
/// and cv::sqrBoxFilter run over slices. Else samples are interpolated one by one (trilinear), and cv::reduce follows.
/// Then each tube core is a row of a matrix, for cv::boxFilter, cv::log, cv::filter2D, cv::sort and cv::exp.
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
