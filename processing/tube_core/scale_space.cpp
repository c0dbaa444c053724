#include "processing/tube_core/scale_space.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace echolucent {

namespace {
/// Results computed together, in registers.
constexpr std::size_t block = 8;
}  // namespace

GaussianKernel::GaussianKernel(double sigma, double cut) {
    const int radius = std::max(0, static_cast<int>(std::floor(cut * sigma)));
    const auto gaussian = [sigma](int distance) { return std::exp(-0.5 * (distance / sigma) * (distance / sigma)); };
    const double end = gaussian(radius + 1);
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
        m_weights.push_back(gaussian(i) - end);
        sum += (i == 0 ? 1.0 : 2.0) * m_weights.back();
    }
    for (double& weight : m_weights) weight /= sum;
}

void GaussianKernel::smooth(std::span<const double> function, std::vector<double>& result,
                            std::vector<double>& padded) const {
    const std::size_t count = function.size(), radius = m_weights.size() - 1;
    const std::size_t blocks = (count + block - 1) / block;
    padded.assign(radius + blocks * block + radius, 0.0);
    std::copy(function.begin(), function.end(), padded.begin() + static_cast<std::ptrdiff_t>(radius));
    for (std::size_t i = 0; i < std::min(radius, count); ++i) padded[radius - 1 - i] = function[i];
    result.resize(blocks * block);
    // Every result is the same sequence of operations, whatever its place, so that equal surroundings give equal bits.
    for (std::size_t start = 0; start < blocks * block; start += block) {
        const double* centre = padded.data() + radius + start;
        std::array<double, block> sums{};
        for (std::size_t j = 0; j < block; ++j) sums[j] = m_weights[0] * centre[j];
        for (std::size_t distance = 1; distance <= radius; ++distance) {
            const double weight = m_weights[distance];
            const double *before = centre - distance, *after = centre + distance;
            for (std::size_t j = 0; j < block; ++j) sums[j] += weight * (before[j] + after[j]);
        }
        std::copy(sums.begin(), sums.end(), result.begin() + static_cast<std::ptrdiff_t>(start));
    }
    result.resize(count);
}

std::vector<GaussianKernel> scaleSpaceKernels(int coarsest, int finest, double sigmaPerKernelSize, double cut) {
    std::vector<GaussianKernel> kernels;
    for (int n = coarsest; n >= finest; --n) kernels.emplace_back(sigmaPerKernelSize * std::ldexp(1.0, n), cut);
    return kernels;
}

}  // namespace echolucent
