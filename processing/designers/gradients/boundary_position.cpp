#include "processing/designers/gradients/boundary_position.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace echolucent {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double reliableVoxels = 30.0;  ///< a node of this many voxels has half the weight of one with very many
constexpr double leastVoxels = 16.0;
constexpr double leastShareOfGradient = 0.3;
constexpr double leastGradient = 1e-4;  ///< a fortieth of a level of 255 over a unit
constexpr double vanishing = 1e-9;      ///< gradients below are rounding

double reliability(double voxels) { return voxels / (voxels + reliableVoxels); }

/// Weighted means around one node.
struct Mean {
    double intensity = 0.0, gradient = 0.0, second = 0.0;
};

std::optional<Mean> meanAround(const std::vector<DerivativeSums>& sums, int node, double smoothing) {
    const int reach = static_cast<int>(std::ceil(3.0 * smoothing));
    double voxels = 0.0, weights = 0.0;
    Mean mean;
    for (int i = std::max(0, node - reach); i <= std::min(HistogramVolume::intensityNodes - 1, node + reach); ++i) {
        const DerivativeSums& here = sums[static_cast<std::size_t>(i)];
        if (here.voxels == 0.0) continue;
        const double apart = i == node ? 0.0 : (i - node) / smoothing;
        const double near = std::exp(-0.5 * apart * apart);
        const double weight = near * reliability(here.voxels) / here.voxels;
        voxels += near * here.voxels;
        weights += weight * here.voxels;
        mean.intensity += weight * here.intensities;
        mean.gradient += weight * here.gradients;
        mean.second += weight * here.seconds;
    }
    if (voxels < leastVoxels) return std::nullopt;
    return Mean{mean.intensity / weights, mean.gradient / weights, mean.second / weights};
}

/// The known means, by ascending intensity.
std::vector<Mean> knownMeans(const std::vector<DerivativeSums>& sums, double smoothing) {
    std::vector<Mean> means;
    for (int node = 0; node < HistogramVolume::intensityNodes; ++node) {
        const std::optional<Mean> mean = meanAround(sums, node, smoothing);
        // Nodes with the same voxels have the same mean, so one stands for all.
        if (mean && (means.empty() || mean->intensity > means.back().intensity + 1e-6)) means.push_back(*mean);
    }
    return means;
}

double positionOf(double gradient, double second, double sigma, double g0) {
    const double above = gradient - g0;
    return above > vanishing ? -sigma * second / above : unknown;
}

/// Voxels, weights, gradients and second derivatives over both axes; rows are nodes of the gradient magnitude.
struct Smoothed {
    cv::Mat voxels, weights, gradients, seconds;
};

Smoothed smoothedOverBoth(const Smoothed& from, double sigma) {
    const auto blurred = [&](const cv::Mat& matrix) {
        cv::Mat result;
        const auto taps = [](double deviation) { return 2 * static_cast<int>(std::ceil(3.0 * deviation)) + 1; };
        cv::GaussianBlur(matrix, result, {taps(sigma), taps(0.5 * sigma)}, sigma, 0.5 * sigma, cv::BORDER_CONSTANT);
        return result;
    };
    return {blurred(from.voxels), blurred(from.weights), blurred(from.gradients), blurred(from.seconds)};
}

Smoothed matricesOf(const HistogramVolume& histogram) {
    const auto matrix = [&] {
        return cv::Mat(cv::Mat::zeros(histogram.gradientNodes, HistogramVolume::intensityNodes, CV_64F));
    };
    Smoothed all{matrix(), matrix(), matrix(), matrix()};
    for (int row = 0; row < histogram.gradientNodes; ++row)
        for (int column = 0; column < HistogramVolume::intensityNodes; ++column) {
            const DerivativeSums& here =
                histogram.overBoth[static_cast<std::size_t>(row * HistogramVolume::intensityNodes + column)];
            if (here.voxels == 0.0) continue;
            const double weight = reliability(here.voxels);
            all.voxels.at<double>(row, column) = here.voxels;
            all.weights.at<double>(row, column) = weight;
            all.gradients.at<double>(row, column) = weight * here.gradients / here.voxels;
            all.seconds.at<double>(row, column) = weight * here.seconds / here.voxels;
        }
    return all;
}

}  // namespace

MeanDerivatives meanDerivatives(const HistogramVolume& histogram, double smoothing) {
    const std::vector<Mean> means = knownMeans(histogram.overIntensity, smoothing);
    MeanDerivatives result{std::vector<double>(HistogramVolume::intensityNodes, unknown),
                           std::vector<double>(HistogramVolume::intensityNodes, unknown)};
    if (means.empty()) return result;
    constexpr double step = 1.0 / (HistogramVolume::intensityNodes - 1);
    for (int node = 0; node < HistogramVolume::intensityNodes; ++node) {
        const double intensity = node * step;
        if (intensity < means.front().intensity - 0.5 * step || intensity > means.back().intensity + 0.5 * step)
            continue;
        const auto behind = std::ranges::upper_bound(means, intensity, {}, &Mean::intensity);
        const Mean& low = behind == means.begin() ? *behind : *(behind - 1);
        const Mean& high = behind == means.end() ? means.back() : *behind;
        const double apart = high.intensity - low.intensity;
        const double share = apart > 0.0 ? (intensity - low.intensity) / apart : 0.0;
        result.gradient[static_cast<std::size_t>(node)] = std::lerp(low.gradient, high.gradient, share);
        result.second[static_cast<std::size_t>(node)] = std::lerp(low.second, high.second, share);
    }
    return result;
}

std::optional<BoundaryWidth> boundaryWidth(const MeanDerivatives& means, double prefilter, double widest) {
    BoundaryWidth width;
    width.prefilter = prefilter;
    for (const double gradient : means.gradient)
        if (gradient > width.largestGradient) width.largestGradient = gradient;
    if (!(width.largestGradient > leastGradient)) return std::nullopt;
    width.largestSecond = -std::numeric_limits<double>::infinity();
    width.leastSecond = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < means.gradient.size(); ++i) {
        if (!(means.gradient[i] >= leastShareOfGradient * width.largestGradient)) continue;
        width.largestSecond = std::max(width.largestSecond, means.second[i]);
        width.leastSecond = std::min(width.leastSecond, means.second[i]);
    }
    const double range = std::sqrt(std::numbers::e) * (width.largestSecond - width.leastSecond);
    if (!(2.0 * width.largestGradient <= widest * range)) return std::nullopt;
    width.smoothed = 2.0 * width.largestGradient / range;
    width.sigma = std::sqrt(std::max(0.0, width.smoothed * width.smoothed - prefilter * prefilter));
    return width;
}

std::vector<double> boundaryPositions(const MeanDerivatives& means, const BoundaryWidth& width, double threshold) {
    std::vector<double> positions;
    for (std::size_t i = 0; i < means.gradient.size(); ++i)
        positions.push_back(
            positionOf(means.gradient[i], means.second[i], width.smoothed, threshold * width.largestGradient));
    return positions;
}

std::vector<double> boundaryPositions(const HistogramVolume& histogram, const BoundaryWidth& width, double threshold) {
    constexpr double finest = 1.5;  // nodes
    constexpr double leastFound = 4.0;
    std::vector<double> positions(histogram.overBoth.size(), unknown);
    const Smoothed sums = matricesOf(histogram);
    // Pictures see the boundary's own sigma, without the prefilter.
    const double stretch = width.smoothed / std::max(width.sigma, 0.5 * width.smoothed);
    std::vector<bool> found(positions.size(), false);
    for (const double sigma : {finest, 2.0 * finest, 4.0 * finest}) {
        const Smoothed means = smoothedOverBoth(sums, sigma);
        // The Gaussian leaves this share of a value on its own node.
        const double middle = 1.0 / (2.0 * std::numbers::pi * sigma * 0.5 * sigma);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const int row = static_cast<int>(i) / HistogramVolume::intensityNodes,
                      column = static_cast<int>(i) % HistogramVolume::intensityNodes;
            if (found[i] || means.voxels.at<double>(row, column) < leastFound * middle) continue;
            found[i] = true;
            const double weight = means.weights.at<double>(row, column);
            positions[i] = stretch * positionOf(means.gradients.at<double>(row, column) / weight,
                                                means.seconds.at<double>(row, column) / weight, width.smoothed,
                                                threshold * width.largestGradient);
        }
    }
    return positions;
}

}  // namespace echolucent
