// Functions along a tube core, their smoothing and their comparison.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "processing/detection/scale_space.h"

namespace echolucent {

/// A straight line from `first` to `last` of `length` samples, at least one.
inline std::vector<double> rampOf(std::size_t length, double first, double last) {
    std::vector<double> signal(length);
    for (std::size_t i = 0; i < length; ++i)
        signal[i] =
            first + (last - first) * static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(length - 1, 1));
    return signal;
}

/// The function smoothed by a Gaussian of this sigma, in samples. All but the scales is as the rule says.
inline std::vector<double> smoothed(const std::vector<double>& function, double sigma, VarianceRule rule = {}) {
    rule.coarsestScale = rule.finestScale = 0;
    rule.sigmaPerKernelSize = sigma;
    const ScaleSpace space(rule);
    ScaleSmoother smoother(space);
    std::vector<double> result;
    smoother.begin(function);
    smoother.smooth(0, result);
    return result;
}

/// The largest difference of two functions, sample by sample. Fails the test if their lengths differ.
inline double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace echolucent
