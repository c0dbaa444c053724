// The limit of memory that keeps small files from filling the machine.
#include "io/files/reading_memory.h"

#include <algorithm>

#include <fmt/format.h>

namespace echolucent {

std::uint64_t mostReadingMemory(std::uint64_t storedBytes) {
    constexpr std::uint64_t alwaysAllowed = std::uint64_t{896} << 20;
    constexpr std::uint64_t largestRatio = 96;
    constexpr std::uint64_t largestFile = std::uint64_t{1} << 56;  // the product of a larger one could overflow
    return std::max(alwaysAllowed, std::min(storedBytes, largestFile) * largestRatio);
}

Result<void> requireReadingMemory(const std::string& file, const std::string& element, std::uint64_t neededBytes,
                                  std::uint64_t storedBytes) {
    if (neededBytes <= mostReadingMemory(storedBytes)) return {};
    return fail(
        FailureKind::unreadable, file, element,
        fmt::format(
            "declares voxels that would take {} MiB of memory out of a file of {} bytes, as no scan of echoes does",
            neededBytes >> 20, storedBytes),
        "Unpack it, or save it without compression, if you trust it, and open what comes out.");
}

}  // namespace echolucent
