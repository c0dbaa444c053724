#include "io/restricted/reader_limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "io/files/input_file.h"
#include "io/files/reading_memory.h"

namespace echolucent::restricted {

ReaderLimits limitsFor(std::uint64_t bytes) {
    constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
    // For stacks of threads and the allocator's reserves; most of it is never touched.
    constexpr std::uint64_t besideVoxels = 256 * mebibyte;
    constexpr std::uint64_t secondsAtLeast = 20, secondsAMebibyte = 2;
    const std::uint64_t counted = std::min(bytes, machineMemoryBytes());
    return {std::min(machineMemoryBytes(), mostReadingMemory(counted)) + besideVoxels,
            secondsAtLeast + secondsAMebibyte * (counted / mebibyte)};
}

void holdTo(const ReaderLimits& limits, int process, std::uint64_t baseBytes) {
    const auto hold = [process](auto resource, std::uint64_t most) {
        // Never exceed the limit that the machine's owner set.
        rlimit limit{};
        if (prlimit(process, resource, nullptr, &limit) != 0) return;
        limit.rlim_cur = std::min<rlim_t>(most, limit.rlim_max);
        prlimit(process, resource, &limit, nullptr);
    };
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    hold(RLIMIT_AS, baseBytes + limits.memoryBytes);
#else
    static_cast<void>(baseBytes);
#endif
    hold(RLIMIT_CPU, limits.processorSeconds);
}

std::uint64_t addressSpaceOf(int process) {
    std::ifstream status(fmt::format("/proc/{}/statm", process));
    std::uint64_t pages = 0;
    status >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace echolucent::restricted
