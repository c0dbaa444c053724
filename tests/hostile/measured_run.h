// A command as a process of its own, with a bound on its time: how it ended and what it took.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace echolucent {

/// How a command ended.
struct MeasuredRun {
    int status = -1;               ///< exit status; -1 where a signal ended it
    int signal = 0;                ///< that ended it; 0 where it ended by itself
    bool hangs = false;            ///< whether it was ended since its time was over
    bool leavesProcesses = false;  ///< whether processes that it had started went on a second after its end
    double seconds = 0.0;
    /// The most memory that the command or one process that it waited for held, as the kernel counts it.
    std::int64_t largestProcessBytes = 0;
    /// The largest sum over the command and what it had started, as seen every 5 ms: shared pages count twice, and what
    /// lived for less may be missed.
    std::int64_t sumOfProcessesBytes = 0;
    std::string output, errors;

    /// The larger of both.
    [[nodiscard]] std::int64_t memoryBytes() const;
};

/// Runs the program and arguments, which begin with the program's path, and keeps files of its own in the existing
/// folder `scratch`. The whole group of processes is killed after `boundSeconds`. Any number of threads may call it,
/// each with a folder of its own. Throws std::runtime_error where no process can be started.
[[nodiscard]] MeasuredRun measuredRun(const std::vector<std::string>& command, const std::filesystem::path& scratch,
                                      double boundSeconds);

}  // namespace echolucent
