#include "app/measuring/measures/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace echolucent {

namespace {

constexpr double white = 255.0;
constexpr int windowEdge = 11;
constexpr double windowSigma = 1.5;

void requireEqualSizes(const Picture& picture, const Picture& reference) {
    if (picture.width != reference.width || picture.height != reference.height ||
        picture.rgba.size() != reference.rgba.size())
        throw std::invalid_argument("differenceOf: the pictures differ in size");
}

/// The luminance in 8-bit levels.
cv::Mat1d luminanceOf(const Picture& picture) {
    cv::Mat1d luminance(picture.height, picture.width);
    const float* pixel = picture.rgba.data();
    for (double& value : luminance) {
        value = white * (0.2126 * static_cast<double>(pixel[0]) + 0.7152 * static_cast<double>(pixel[1]) +
                         0.0722 * static_cast<double>(pixel[2]));
        pixel += 4;
    }
    return luminance;
}

cv::Mat1d windowMeans(const cv::Mat1d& values) {
    cv::Mat1d means;
    cv::GaussianBlur(values, means, cv::Size(windowEdge, windowEdge), windowSigma, windowSigma, cv::BORDER_REFLECT_101);
    return means;
}

double structuralSimilarity(const cv::Mat1d& a, const cv::Mat1d& b) {
    constexpr double c1 = 0.01 * white * 0.01 * white, c2 = 0.03 * white * 0.03 * white;
    const cv::Mat1d meanA = windowMeans(a), meanB = windowMeans(b);
    const cv::Mat1d squaresA = windowMeans(a.mul(a)), squaresB = windowMeans(b.mul(b)),
                    products = windowMeans(a.mul(b));
    const auto border = [](int edge) { return edge >= windowEdge ? windowEdge / 2 : 0; };
    double sum = 0.0;
    int count = 0;
    for (int row = border(a.rows); row < a.rows - border(a.rows); ++row)
        for (int column = border(a.cols); column < a.cols - border(a.cols); ++column) {
            const double ma = meanA(row, column), mb = meanB(row, column);
            const double varianceA = squaresA(row, column) - ma * ma, varianceB = squaresB(row, column) - mb * mb;
            const double covariance = products(row, column) - ma * mb;
            sum += (2.0 * ma * mb + c1) * (2.0 * covariance + c2) /
                   ((ma * ma + mb * mb + c1) * (varianceA + varianceB + c2));
            ++count;
        }
    return sum / count;
}

}  // namespace

PictureDifference differenceOf(const Picture& picture, const Picture& reference) {
    requireEqualSizes(picture, reference);
    PictureDifference result;
    if (picture.rgba.empty()) return result;
    double squares = 0.0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const double difference = static_cast<double>(picture.rgba[i]) - static_cast<double>(reference.rgba[i]);
        squares += difference * difference;
        result.largest = std::max(result.largest, std::abs(difference));
    }
    const std::size_t values = picture.rgba.size() / 4 * 3;
    result.rms = std::sqrt(squares / static_cast<double>(values));
    return result;
}

PictureError pictureError(const Picture& picture, const Picture& reference) {
    const PictureDifference difference = differenceOf(picture, reference);
    PictureError error{white * difference.rms, white * difference.largest};
    if (picture.rgba.empty()) return error;
    error.ssim = structuralSimilarity(luminanceOf(picture), luminanceOf(reference));
    return error;
}

Picture signedDifference(const Picture& picture, const Picture& reference, double amplification) {
    requireEqualSizes(picture, reference);
    Picture difference{picture.width, picture.height, picture.rgba, {}};
    for (std::size_t i = 0; i < difference.rgba.size(); ++i) {
        const double signedOne = static_cast<double>(picture.rgba[i]) - static_cast<double>(reference.rgba[i]);
        difference.rgba[i] =
            i % 4 == 3 ? 1.0f : static_cast<float>(std::clamp(0.5 + amplification * signedOne, 0.0, 1.0));
    }
    return difference;
}

}  // namespace echolucent
