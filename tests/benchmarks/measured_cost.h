// Measures a piece of work: wall time, and CPU time of all threads of the process.
#pragma once

#include <functional>
#include <vector>

namespace echolucent::bench {

struct Cost {
    double wallMs = 0.0;
    double cpuMs = 0.0;  ///< of all threads together
};

/// The CPU time of the process with all its threads until now, ms.
[[nodiscard]] double processCpuMs();
[[nodiscard]] double wallClockMs();

/// Wall time until the work returns. CPU time also holds what worker threads burn afterwards until they sleep: oneTBB's
/// threads look for more work for a while. The work that woke them must pay for that, not the next measurement.
[[nodiscard]] Cost costOf(const std::function<void()>& work);

/// Medians of wall and CPU time, each by itself.
[[nodiscard]] Cost medianOf(const std::vector<Cost>& costs);

}  // namespace echolucent::bench
