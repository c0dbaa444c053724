// MetaImages and NRRDs to begin from.
#pragma once

#include <vector>

#include "tests/fuzz/fuzz_target.h"

namespace echolucent {

[[nodiscard]] std::vector<FuzzSample> metaImageSamples();
[[nodiscard]] std::vector<FuzzSample> nrrdSamples();

}  // namespace echolucent
