#include "processing/pane_picture/small_picture.h"

#include <opencv2/imgproc.hpp>

namespace echolucent {

std::optional<Picture> smallPicture(PaneCaster& caster, const Document& document, std::size_t pane, int width,
                                    int height, const Progress& progress) {
    const auto otf = caster.otf(document, pane, progress);
    if (!otf) return std::nullopt;
    return smallPictureWith(caster, *otf, document, pane, width, height, progress);
}

std::optional<Picture> smallPictureWith(PaneCaster& caster, const PaneOtf& otf, const Document& document,
                                        std::size_t pane, int width, int height, const Progress& progress) {
    auto large = caster.pictureWith(otf, document, pane, 2 * width, 2 * height, progress, PictureQuality::quick);
    if (!large) return std::nullopt;
    Picture small = emptyPicture(width, height);
    const cv::Mat from(2 * height, 2 * width, CV_32FC4, large->picture.rgba.data());
    cv::Mat to(height, width, CV_32FC4, small.rgba.data());
    cv::resize(from, to, to.size(), 0, 0, cv::INTER_AREA);
    return small;
}

}  // namespace echolucent
