// How much memory and time reading may take, by what is read.
#pragma once

#include <cstdint>

namespace echolucent::restricted {

/// What a reader process may use.
struct ReaderLimits {
    std::uint64_t memoryBytes = 0;       ///< address space beyond what it has when it begins
    std::uint64_t processorSeconds = 0;  ///< of all its threads together
    friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

/// The limits where files of so many bytes were opened: the memory of mostReadingMemory() and what a process needs
/// beside it, and seconds that no file of that size takes.
[[nodiscard]] ReaderLimits limitsFor(std::uint64_t bytes);

/// Holds a running process to limits whose memory is counted from `baseBytes` on. Not where it runs under a sanitizer,
/// whose shadow memory would count.
void holdTo(const ReaderLimits& limits, int process, std::uint64_t baseBytes);

/// The address space of a running process, 0 where it cannot be told.
[[nodiscard]] std::uint64_t addressSpaceOf(int process);

}  // namespace echolucent::restricted
