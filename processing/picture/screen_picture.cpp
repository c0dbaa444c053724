#include "processing/picture/screen_picture.h"

#include <opencv2/core/mat.hpp>

namespace echolucent {

ScreenPicture screenPicture(const Picture& picture) {
    ScreenPicture screen{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size()),
                         picture.depthMm};
    const cv::Mat_<float> colours(1, static_cast<int>(picture.rgba.size()), const_cast<float*>(picture.rgba.data()));
    cv::Mat_<std::uint8_t> bytes(1, colours.cols, screen.rgba.data());
    colours.convertTo(bytes, CV_8U, 255.0);
    return screen;
}

}  // namespace echolucent
