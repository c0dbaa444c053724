// Inputs of the reference values in tests/fixtures and in study_stability_reference.cpp. They equal those of
// tests/fixtures/make_reference.py, because both round every operation alike.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "processing/phantom/splitmix.h"

namespace echolucent::reference {

/// A number in [0,1) that is a multiple of 2^-53.
inline double unit(std::uint64_t counter) { return static_cast<double>(splitmix64(counter) >> 11) * 0x1p-53; }

struct Range {
    double low, high;
};

/// A range in [0,1] whose gap is 1e-9 to 1. Gaps of all octaves are equally frequent.
inline Range narrowOrWide(std::uint64_t counter) {
    const double gap =
        std::max(1e-9, std::ldexp(0.5 + 0.5 * unit(counter), -static_cast<int>(splitmix64(counter + 1) % 31)));
    const double low = unit(counter + 2) * (1.0 - gap);
    return {low, std::min(1.0, low + gap)};
}

struct BasisInput {
    double intensity;
    Range range;
};

/// Row i of basis_function.csv: every fourth intensity lies anywhere in [0,1], the other three near the range.
inline BasisInput basisInput(std::uint64_t i) {
    const Range range = narrowOrWide(8 * i);
    const double share = unit(8 * i + 3);
    const double x = i % 4 == 0 ? share : range.low + (6.0 * share - 2.5) * (range.high - range.low);
    return {std::min(1.0, std::max(0.0, x)), range};
}

struct TubeInput {
    double d;
    Range range;
};

/// Tube core t of log_opacity_*.csv: every eighth has a range of narrowOrWide(). The range of any other is 0.1 to 0.6
/// wide.
inline TubeInput tubeInput(std::uint64_t t, double dMax) {
    const std::uint64_t counter = (std::uint64_t{1} << 40) + 8 * t;
    const double d = dMax * unit(counter + 3);
    if (t % 8 == 0) return {d, narrowOrWide(counter)};
    const double low = 0.3 * unit(counter);
    return {d, {low, low + (0.1 + 0.5 * unit(counter + 1))}};
}

/// Voxel i of 16-bit data of mean 65,000.
inline std::uint16_t brightVoxel(std::uint64_t i) {
    return static_cast<std::uint16_t>(64465 + splitmix64((std::uint64_t{1} << 41) + i) % 1071);
}

}  // namespace echolucent::reference
