// Detection by the variance of cells, tracked through scale space (Petersch 2005, section 4.1).
#pragma once

namespace echolucent {

/// What stands beyond a tube's ends while its interface function is smoothed.
enum class TubeBorder {
    mirrorThenZero,  ///< the function mirrored in front, zero behind the far end
    circular,        ///< the other end of the function, as an FFT without padding gives it
};

/// How the interface function is convolved with a Gaussian.
enum class SmoothingRoute { direct, fourier };

/// Lengths are in units: the volume's smallest spacing. The ranges stand in methodParameters().
struct VarianceRule {
    int coarsestScale = 7;             ///< the widest Gaussian kernel has size 2^coarsestScale units
    int finestScale = 3;               ///< the narrowest Gaussian kernel has size 2^finestScale units
    double sigmaPerKernelSize = 0.25;  ///< standard deviation of a kernel, in sizes of that kernel
    double kernelCut = 3.0;            ///< kernels end at this many standard deviations and are renormalised
    bool kernelEndsAtZero = true;      ///< whether kernels are lowered so that they end at zero; else they are cut
    TubeBorder border = TubeBorder::mirrorThenZero;
    SmoothingRoute smoothing = SmoothingRoute::direct;
    double significance = 0.4;   ///< a local maximum counts if it reaches this share of the largest value in its range
    double floorQuantile = 0.1;  ///< this quantile of a tube's interface function is subtracted before tracking; if 0,
                                 ///< nothing is
    double trackingRangeSigmas = 0.0;  ///< the next scale looks this many of the present scale's standard deviations
                                       ///< around its maximum; if 0, from valley to valley
    bool coarsestMustHaveMaximum = false;  ///< if true, there is no surface without a maximum at the coarsest scale;
                                           ///< else tracking begins at the coarsest scale with a maximum
    double leastEdgeToNoise = 4.0;  ///< a surface with less edge to noise has no weight: ranks are relative, this test
                                    ///< is absolute; if 0, there is no test
    friend bool operator==(const VarianceRule&, const VarianceRule&) = default;
};

}  // namespace echolucent
