// The interface indicating function at coarse to fine scales: convolution with Gaussians (Petersch 2005, section 4.1).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "processing/tube_core/rules/variance_rule.h"

namespace echolucent {

/// A sampled Gaussian, cut and renormalised. It is symmetric, has an odd number of weights, and they sum to 1.
class GaussianKernel {
public:
    /// `sigma` is in samples, above 0; the kernel ends at cut * sigma. If endsAtZero, the kernel is lowered to end at
    /// zero and then renormalised. A kernel that ends in a step makes a false maximum if its end passes over a peak.
    GaussianKernel(double sigma, double cut, bool endsAtZero = true);
    [[nodiscard]] int radius() const { return static_cast<int>(m_weights.size()) - 1; }
    /// Weight at distance 0 ... radius().
    [[nodiscard]] double weight(int distance) const { return m_weights[static_cast<std::size_t>(distance)]; }
    [[nodiscard]] std::span<const double> weights() const { return m_weights; }

private:
    std::vector<double> m_weights;
};

/// The scales of a rule, coarsest first, and how a function is continued and convolved. Lengths are in samples of the
/// function, which are units along the tube core.
class ScaleSpace {
public:
    explicit ScaleSpace(const VarianceRule& rule);
    [[nodiscard]] std::size_t scales() const { return m_sigmas.size(); }
    /// The standard deviation of a scale's kernel, samples; scale 0 is the coarsest.
    [[nodiscard]] double sigma(std::size_t scale) const { return m_sigmas[scale]; }
    [[nodiscard]] const GaussianKernel& kernel(std::size_t scale) const { return m_kernels[scale]; }
    /// The radius of the coarsest kernel, samples.
    [[nodiscard]] std::size_t largestRadius() const;
    [[nodiscard]] TubeBorder border() const { return m_border; }
    [[nodiscard]] SmoothingRoute route() const { return m_route; }

private:
    TubeBorder m_border;
    SmoothingRoute m_route;
    std::vector<double> m_sigmas;
    std::vector<GaussianKernel> m_kernels;
};

/// Smooths one function after the other. Each thread needs its own.
///
/// Borders: mirrorThenZero mirrors the function once before its first sample (f(-1 - i) = f(i)), and is zero before the
/// mirror image and behind the last sample. circular repeats the function on both sides.
///
/// Routes: direct adds up products and gives equal surroundings equal bits. So a constant function becomes one value to
/// the last bit, out of reach of the zeros. fourier multiplies spectra (cv::dft; padded for mirrorThenZero, not for
/// circular) and equals direct to rounding.
class ScaleSmoother {
public:
    explicit ScaleSmoother(const ScaleSpace& space) : m_space(space) {}
    explicit ScaleSmoother(const ScaleSpace&&) = delete;
    [[nodiscard]] const ScaleSpace& space() const { return m_space; }
    /// Takes the next function to smooth. It must stay in place until the last smooth().
    void begin(std::span<const double> function);
    /// The function at a scale.
    void smooth(std::size_t scale, std::vector<double>& result);

private:
    void continueFunction(std::size_t before, std::size_t length);
    void convolve(const GaussianKernel& kernel, std::vector<double>& result) const;
    void transformKernels(std::size_t length);
    void multiplySpectra(std::size_t scale, std::vector<double>& result);

    const ScaleSpace& m_space;
    std::span<const double> m_function;
    std::vector<double> m_continued;  ///< the function and its continuation beyond both ends
    std::size_t m_before = 0;         ///< samples in front of the function in m_continued
    std::vector<double> m_spectrum, m_product;
    std::vector<std::vector<double>> m_kernelSpectra;  ///< for the last length; most tubes of a view share it
};

}  // namespace echolucent
