// The program's memory, as the system counts it.
#pragma once

namespace echolucent::bench {

/// MiB of resident memory now, and the most since forgetPeak() or the start; 0 if the system does not tell.
struct Memory {
    double residentMiB = 0.0, peakMiB = 0.0;
};
[[nodiscard]] Memory memoryNow();
/// Counts the peak anew from here on.
void forgetPeak();

}  // namespace echolucent::bench
