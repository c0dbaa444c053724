// NIfTI, GE Voluson and packed files to begin from.
#pragma once

#include <vector>

#include "tests/fuzz/fuzz_target.h"

namespace echolucent {

[[nodiscard]] std::vector<FuzzSample> niftiSamples();
[[nodiscard]] std::vector<FuzzSample> kretzSamples();
[[nodiscard]] std::vector<FuzzSample> gzipSamples();

}  // namespace echolucent
