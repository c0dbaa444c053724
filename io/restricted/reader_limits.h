// How much memory and time reading may take, by the bytes read.
#pragma once

#include <cstdint>

namespace echolucent::restricted {

struct ReaderLimits {
    std::uint64_t memoryBytes = 0;       ///< address space beyond that of its start
    std::uint64_t processorSeconds = 0;  ///< of all its threads together
    friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

/// The limits of a reader that opened files of `bytes` bytes in all. The memory is mostReadingMemory(), at most the
/// machine's, and what a process needs beside voxels. The processor time is 20 s and 2 s for each MiB. Bytes beyond the
/// machine's memory do not count.
[[nodiscard]] ReaderLimits limitsFor(std::uint64_t bytes);

/// Holds a running process to limits. Memory counts from `baseBytes` on. Under the address and thread
/// sanitizers only the time is limited, because their own memory would count.
void holdTo(const ReaderLimits& limits, int process, std::uint64_t baseBytes);

/// The address space of a running process; 0 if it is unknown.
[[nodiscard]] std::uint64_t addressSpaceOf(int process);

}  // namespace echolucent::restricted
