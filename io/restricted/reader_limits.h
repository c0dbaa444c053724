// How much memory and time reading may take, by the bytes read.
#pragma once

#include <cstdint>

namespace echolucent::restricted {

struct ReaderLimits {
    std::uint64_t memoryBytes = 0;       ///< address space beyond that of its start
    std::uint64_t processorSeconds = 0;  ///< of all its threads together
    friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

/// The limits if files of so many bytes were opened. The memory is that of mostReadingMemory() and what a process needs
/// beside it. No file of that size takes so many seconds.
[[nodiscard]] ReaderLimits limitsFor(std::uint64_t bytes);

/// Holds a running process to limits. Memory counts from `baseBytes` on. Does nothing under a sanitizer, whose shadow
/// memory would count.
void holdTo(const ReaderLimits& limits, int process, std::uint64_t baseBytes);

/// The address space of a running process; 0 if it is unknown.
[[nodiscard]] std::uint64_t addressSpaceOf(int process);

}  // namespace echolucent::restricted
