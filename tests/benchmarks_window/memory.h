// What the program's memory is, as the system counts it.
#pragma once

namespace echolucent::bench {

/// MiB of memory that is resident now, and the most that ever was since forgetPeak() or the start; 0 where the system
/// does not tell.
struct Memory {
    double residentMiB = 0.0, peakMiB = 0.0;
};
[[nodiscard]] Memory memoryNow();
/// The peak is counted anew from here on.
void forgetPeak();

}  // namespace echolucent::bench
