// What a piece of work costs: wall time, and CPU time of all threads of the process.
#pragma once

#include <functional>
#include <vector>

namespace echolucent::bench {

/// What was spent, in milliseconds.
struct Cost {
    double wallMs = 0.0;
    double cpuMs = 0.0;  ///< of all threads together
};

/// The CPU time of the process and all its threads until now, ms.
[[nodiscard]] double processCpuMs();
[[nodiscard]] double wallClockMs();

/// Wall time until the work returns. The CPU time also holds what worker threads burn afterwards until they sleep:
/// oneTBB's look for more work for a while, and that must be charged to who woke them, not to who is measured next.
[[nodiscard]] Cost costOf(const std::function<void()>& work);

/// Medians of wall and CPU time, each by itself.
[[nodiscard]] Cost medianOf(const std::vector<Cost>& costs);

}  // namespace echolucent::bench
