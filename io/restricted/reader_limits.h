// How much memory and time reading may take, by the bytes read.
#pragma once

#include <cstdint>

namespace echolucent::restricted {

struct ReaderLimits {
    std::uint64_t memoryBytes = 0;       ///< address space beyond what the process had at its start
    std::uint64_t processorSeconds = 0;  ///< of all threads of the process together
    friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

/// The limits of a reader that opened files of `bytes` bytes in all. The memory is mostReadingMemory() or the
/// machine's, whichever is less, plus what a process needs beside voxels. The processor time is 20 s plus 2 s for each
/// MiB. Bytes beyond the machine's memory do not count.
[[nodiscard]] ReaderLimits limitsFor(std::uint64_t bytes);

/// Holds a running process to limits. Memory counts from `baseBytes` on. A limit that the machine's owner set is never
/// raised. Under the address and thread sanitizers only the time is limited, because the sanitizers' own memory would
/// count.
void holdTo(const ReaderLimits& limits, int process, std::uint64_t baseBytes);

/// The address space of a running process; 0 if it is unknown.
[[nodiscard]] std::uint64_t addressSpaceOf(int process);

}  // namespace echolucent::restricted
