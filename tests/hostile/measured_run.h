// Runs a command as a process of its own with a bound on its time, and measures it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace echolucent {

/// How a command ended.
struct MeasuredRun {
    int status = -1;               ///< exit status; -1 if a signal ended it
    int signal = 0;                ///< the signal that ended it; 0 if it ended by itself
    bool hangs = false;            ///< whether it was ended because its time was over
    bool leavesProcesses = false;  ///< whether processes that it had started still ran a second after its end
    double seconds = 0.0;
    /// The most memory of the command or of one process that it waited for, as the kernel counts it.
    std::int64_t largestProcessBytes = 0;
    /// The largest sum over the command and its processes, sampled every 5 ms. Shared pages count twice; shorter peaks
    /// may be missed.
    std::int64_t sumOfProcessesBytes = 0;
    std::string output, errors;

    /// The larger of both.
    [[nodiscard]] std::int64_t memoryBytes() const;
};

/// Runs `command`, the program's path and its arguments. Keeps files of its own in the existing folder `scratch`. The
/// whole group of processes is killed after `boundSeconds`. Any number of threads may call it, each with its own
/// folder. Throws std::runtime_error if no process can be started.
[[nodiscard]] MeasuredRun measuredRun(const std::vector<std::string>& command, const std::filesystem::path& scratch,
                                      double boundSeconds);

}  // namespace echolucent
