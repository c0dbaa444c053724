// JSON files of the program to begin from, and layouts beside raw files.
#pragma once

#include <vector>

#include "tests/fuzz/fuzz_target.h"

namespace echolucent {

[[nodiscard]] std::vector<FuzzSample> curveSamples();
[[nodiscard]] std::vector<FuzzSample> presetsSamples();
[[nodiscard]] std::vector<FuzzSample> documentSamples();
[[nodiscard]] std::vector<FuzzSample> sessionSamples();
/// Layouts of a raw file of rawVoxelBytes.
[[nodiscard]] std::vector<FuzzSample> rawLayoutSamples();
inline constexpr std::size_t rawVoxelBytes = 4096;

}  // namespace echolucent
