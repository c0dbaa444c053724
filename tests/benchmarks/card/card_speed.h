// How fast a card draws.
#pragma once

#include <array>
#include <vector>

#include "tests/benchmarks/card/card_window.h"

namespace echolucent::bench {

struct SpeedPlan {
    std::vector<int> edges{256, 512};  ///< voxels along an edge of the simulated fetus
    std::vector<std::array<int, 2>> sizes{{1024, 1024}, {1920, 1080}, {3840, 2160}};
    int frames = 20;  ///< that are timed of each row
    int phases = 20;  ///< of a volume of the first edge
};

/// Prints a table of the time to prepare pictures on the processor, to bring them to the card and to draw them: lit,
/// with a flat and a bowed front, while turning and at rest; then of the phases. False if the card fails.
[[nodiscard]] bool measureSpeed(CardWindow& window, const SpeedPlan& plan);

}  // namespace echolucent::bench
