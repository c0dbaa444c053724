#include "processing/detection/scale_space.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "processing/tube_core/slabs/profile_kernels.h"

namespace echolucent {

namespace {

/// Results are computed in multiples of this.
constexpr std::size_t block = 8;

std::size_t wholeBlocks(std::size_t count) { return (count + block - 1) / block * block; }

cv::Mat rowOver(std::vector<double>& values) { return {1, static_cast<int>(values.size()), CV_64F, values.data()}; }

}  // namespace

GaussianKernel::GaussianKernel(double sigma, double cut, bool endsAtZero) {
    const int radius = std::max(0, static_cast<int>(std::floor(cut * sigma)));
    const auto gaussian = [sigma](int distance) { return std::exp(-0.5 * (distance / sigma) * (distance / sigma)); };
    const double end = endsAtZero ? gaussian(radius + 1) : 0.0;
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
        m_weights.push_back(gaussian(i) - end);
        sum += (i == 0 ? 1.0 : 2.0) * m_weights.back();
    }
    for (double& weight : m_weights) weight /= sum;
}

ScaleSpace::ScaleSpace(const VarianceRule& rule) : m_border(rule.border), m_route(rule.smoothing) {
    for (int n = rule.coarsestScale; n >= rule.finestScale; --n) {
        const double sigma = rule.sigmaPerKernelSize * std::ldexp(1.0, n);
        m_sigmas.push_back(sigma);
        m_kernels.emplace_back(sigma, rule.kernelCut, rule.kernelEndsAtZero);
    }
}

std::size_t ScaleSpace::largestRadius() const {
    return m_kernels.empty() ? 0 : static_cast<std::size_t>(m_kernels.front().radius());
}

void ScaleSmoother::begin(std::span<const double> function) {
    m_function = function;
    const std::size_t count = function.size(), radius = m_space.largestRadius();
    if (m_space.route() == SmoothingRoute::direct) {
        continueFunction(radius, radius + wholeBlocks(count) + radius);
        return;
    }
    if (count == 0) return;
    std::size_t length = count;
    if (m_space.border() == TubeBorder::mirrorThenZero) {
        // The zeros are as wide as the radius of the coarsest kernel, so a kernel at any sample of the function meets
        // only zeros where it wraps around.
        const std::size_t mirrored = std::min(radius, count);
        length = static_cast<std::size_t>(cv::getOptimalDFTSize(static_cast<int>(mirrored + count + radius)));
        continueFunction(mirrored, length);
    } else {
        continueFunction(0, length);
    }
    m_spectrum.resize(length);
    cv::Mat spectrum = rowOver(m_spectrum);
    cv::dft(rowOver(m_continued), spectrum);
    transformKernels(length);
}

void ScaleSmoother::smooth(std::size_t scale, std::vector<double>& result) {
    if (m_function.empty()) {
        result.clear();
    } else if (m_space.route() == SmoothingRoute::fourier) {
        multiplySpectra(scale, result);
    } else {
        convolve(m_space.kernel(scale), result);
    }
}

void ScaleSmoother::continueFunction(std::size_t before, std::size_t length) {
    const std::size_t count = m_function.size();
    m_before = before;
    m_continued.assign(length, 0.0);
    if (count == 0) return;
    std::copy(m_function.begin(), m_function.end(), m_continued.begin() + static_cast<std::ptrdiff_t>(before));
    if (m_space.border() == TubeBorder::mirrorThenZero) {
        for (std::size_t i = 0; i < std::min(before, count); ++i) m_continued[before - 1 - i] = m_function[i];
        return;
    }
    for (std::size_t i = 0; i < before; ++i) m_continued[before - 1 - i] = m_function[count - 1 - i % count];
    for (std::size_t i = before + count; i < length; ++i) m_continued[i] = m_function[(i - before) % count];
}

void ScaleSmoother::convolve(const GaussianKernel& kernel, std::vector<double>& result) const {
    const std::size_t count = m_function.size();
    result.resize(wholeBlocks(count));
    // Each result is the same sequence of operations at any place, so that equal surroundings give equal bits.
    echolucent::convolve(m_continued.data() + m_before, kernel.weights(), result);
    result.resize(count);
}

void ScaleSmoother::transformKernels(std::size_t length) {
    if (!m_kernelSpectra.empty() && m_kernelSpectra.front().size() == length) return;
    m_kernelSpectra.assign(m_space.scales(), std::vector<double>(length));
    for (std::size_t scale = 0; scale < m_space.scales(); ++scale) {
        const GaussianKernel& kernel = m_space.kernel(scale);
        std::vector<double> wrapped(length, 0.0);
        wrapped[0] = kernel.weight(0);
        for (int distance = 1; distance <= kernel.radius(); ++distance) {
            // If the kernel is longer than the function, it goes around more than once.
            const std::size_t after = static_cast<std::size_t>(distance) % length;
            wrapped[after] += kernel.weight(distance);
            wrapped[(length - after) % length] += kernel.weight(distance);
        }
        cv::Mat spectrum = rowOver(m_kernelSpectra[scale]);
        cv::dft(rowOver(wrapped), spectrum);
    }
}

void ScaleSmoother::multiplySpectra(std::size_t scale, std::vector<double>& result) {
    m_product.resize(m_spectrum.size());
    cv::Mat product = rowOver(m_product);
    cv::mulSpectrums(rowOver(m_spectrum), rowOver(m_kernelSpectra[scale]), product, 0);
    cv::dft(product, product, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    const auto first = m_product.begin() + static_cast<std::ptrdiff_t>(m_before);
    result.assign(first, first + static_cast<std::ptrdiff_t>(m_function.size()));
}

}  // namespace echolucent
