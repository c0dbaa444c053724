// How much memory reading a file may take for its size on the disc.
#pragma once

#include <cstdint>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// The most memory, in bytes, that reading may take for files of so many bytes: 896 MiB, with which the program stays
/// below 1 GiB, or 96 times the files, whichever is more. Echo packs to a half or a third.
[[nodiscard]] std::uint64_t mostReadingMemory(std::uint64_t storedBytes);

/// Fails (unreadable) with a sentence about `file` and its `element` (a header key; it may be empty) where reading
/// `storedBytes` of files would take `neededBytes` of memory and that is more than mostReadingMemory().
[[nodiscard]] Result<void> requireReadingMemory(const std::string& file, const std::string& element,
                                                std::uint64_t neededBytes, std::uint64_t storedBytes);

}  // namespace echolucent
