#include "app/cli/report/picture_words.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace echolucent::cli {

std::string pictureWordsOf(const VolumeGeometry& geometry) {
    std::string words = geometry.spacingKnown ? "" : "spacing unknown";
    if (geometry.reduction) words += (words.empty() ? "reduced " : ", reduced ") + factorsText(*geometry.reduction);
    return words;
}

std::string pictureNotesOf(const VolumeGeometry& geometry, const std::string& picture) {
    std::string notes;
    if (!geometry.spacingKnown)
        notes = "The spacing of this volume is unknown: proportions in the " + picture + " may be wrong.";
    if (geometry.reduction)
        notes += std::string(notes.empty() ? "" : "\n") + "This volume was reduced " +
                 factorsText(*geometry.reduction) + ": fine detail in the " + picture + " is averaged.";
    return notes;
}

void writeWords(std::vector<std::uint8_t>& rgb, int width, int height, const std::string& words) {
    if (words.empty()) return;
    cv::Mat image(height, width, CV_8UC3, rgb.data());
    const double scale = std::clamp(height / 512.0, 0.3, 4.0) * 0.6;
    const cv::Point corner(width / 50 + 1, height - height / 50 - 2);
    // Dark below light, so that the words are legible on any picture.
    cv::putText(image, words, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(0, 0, 0), 3, cv::LINE_AA);
    cv::putText(image, words, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255, 255, 255), 1, cv::LINE_AA);
}

}  // namespace echolucent::cli
