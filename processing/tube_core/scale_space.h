// The interface indicating function at coarse to fine scales: convolution with Gaussians (Petersch 2005, section 4.1).
#pragma once

#include <span>
#include <vector>

namespace echolucent {

/// A sampled Gaussian, cut, lowered so that it ends at zero, and renormalised: symmetric, odd, its weights sum to 1. A
/// kernel that ends in a step makes a false maximum where its end passes over a peak.
class GaussianKernel {
public:
    /// sigma in samples, above 0; ends at cut * sigma.
    GaussianKernel(double sigma, double cut);
    [[nodiscard]] int radius() const { return static_cast<int>(m_weights.size()) - 1; }
    /// Weight at distance 0 ... radius().
    [[nodiscard]] double weight(int distance) const { return m_weights[static_cast<std::size_t>(distance)]; }

    /// Smooths a function: mirrored in front of its first sample (f(-1 - i) = f(i)), zero behind its last. A constant
    /// stays the same to the last bit as far as the zero is out of reach. padded: scratch. result may not be function.
    void smooth(std::span<const double> function, std::vector<double>& result, std::vector<double>& padded) const;

private:
    std::vector<double> m_weights;
};

/// Kernels of size 2^n, n = coarsest ... finest: sigma = sigmaPerKernelSize * 2^n, ended at cut sigmas.
[[nodiscard]] std::vector<GaussianKernel> scaleSpaceKernels(int coarsest, int finest, double sigmaPerKernelSize,
                                                            double cut);

}  // namespace echolucent
