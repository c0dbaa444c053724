#include "processing/volume/white_level.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace echolucent {

namespace {

/// Biased exponents of a float: octave e holds the values from 2^(e - 127) to below 2^(e - 126).
constexpr int octaves = 255;
constexpr int exponentBias = 127;

/// The octave of a value of at least 0; 0 and the subnormal numbers count as the lowest octave.
std::size_t octaveOf(float value) {
    constexpr int fractionBits = 23;
    return std::bit_cast<std::uint32_t>(value) >> fractionBits;
}

WhiteLevel largestOf(std::span<const Voxels> phases, int endOctave) {
    WhiteLevel white;
    const double end = std::ldexp(1.0, endOctave - exponentBias);
    const auto look = [&](const auto& values) {
        for (const auto stored : values) {
            const double value = static_cast<double>(stored);
            if (!std::isfinite(value)) continue;
            white.largest = std::max(white.largest, value);
            if (value < end)
                white.level = std::max(white.level, value);
            else
                ++white.above;
        }
    };
    for (const Voxels& phase : phases) std::visit(look, phase);
    return white;
}

/// Float voxels above 0, counted by octave.
std::array<std::int64_t, octaves> countOctaves(std::span<const Voxels> phases) {
    std::array<std::int64_t, octaves> counts{};
    for (const Voxels& phase : phases)
        if (const auto* values = std::get_if<std::vector<float>>(&phase))
            for (const float value : *values)
                if (value > 0.0f && std::isfinite(value)) ++counts[octaveOf(value)];
    return counts;
}

}  // namespace

WhiteLevel whiteLevelOf(std::span<const Voxels> phases) {
    constexpr int absurdOctaves = 20, keptOctaves = 2;
    const auto counts = countOctaves(phases);
    std::int64_t all = 0;
    int highest = 0;
    for (int octave = 0; octave < octaves; ++octave) {
        all += counts[static_cast<std::size_t>(octave)];
        if (counts[static_cast<std::size_t>(octave)] > 0) highest = octave;
    }
    // 99 of 100 lie below the end of this octave.
    int common = 0;
    std::int64_t below = counts[0];
    while (100 * below < 99 * all) below += counts[static_cast<std::size_t>(++common)];
    constexpr int noEnd = 2 * octaves;  // above every float
    return largestOf(phases, highest >= common + 1 + absurdOctaves ? common + 1 + keptOctaves : noEnd);
}

}  // namespace echolucent
