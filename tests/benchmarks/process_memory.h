// The memory of a program and of the processes that it started, watched from outside.
#pragma once

#include <string>
#include <vector>

namespace echolucent::bench {

/// What became of a program that was watched.
struct WatchedRun {
    double peakMebibytes =
        0.0;                 ///< most memory at any one time, all its processes together, shared memory counted once
    double seconds = 0.0;    ///< from start to end
    bool succeeded = false;  ///< it ended by itself with status 0
};

/// Runs a program (its path, and its arguments), whose output goes where this program's goes, and looks every few
/// milliseconds at its memory: the proportional set size (Pss) that Linux tells. The program is ended (SIGTERM) after
/// `mostSeconds`.
[[nodiscard]] WatchedRun watch(const std::vector<std::string>& command, double mostSeconds = 1e9);

}  // namespace echolucent::bench
