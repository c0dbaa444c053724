// How much memory reading may take, depending on the size of the files.
#pragma once

#include <cstdint>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// The most memory, in bytes, for reading files of this many bytes: 896 MiB, which keeps the program below 1 GiB, or 96
/// times the files, whichever is more. (Compression shrinks echo only to a half or a third.)
[[nodiscard]] std::uint64_t mostReadingMemory(std::uint64_t storedBytes);

/// Fails (unreadable) if reading `storedBytes` of files takes `neededBytes` of memory, and that is more than
/// mostReadingMemory(). The message names `file` and its `element`, a header key, which may be empty.
[[nodiscard]] Result<void> requireReadingMemory(const std::string& file, const std::string& element,
                                                std::uint64_t neededBytes, std::uint64_t storedBytes);

}  // namespace echolucent
