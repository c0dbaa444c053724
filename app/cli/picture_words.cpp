#include "app/cli/picture_words.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace echolucent::cli {

void writeWords(std::vector<std::uint8_t>& rgb, int width, int height, const char* words) {
    cv::Mat image(height, width, CV_8UC3, rgb.data());
    const double scale = std::clamp(height / 512.0, 0.3, 4.0) * 0.6;
    const cv::Point corner(width / 50 + 1, height - height / 50 - 2);
    // Dark under light, so that it can be read on any picture.
    cv::putText(image, words, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(0, 0, 0), 3, cv::LINE_AA);
    cv::putText(image, words, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255, 255, 255), 1, cv::LINE_AA);
}

}  // namespace echolucent::cli
