// Watches the memory of a program and of the processes that it started, from outside.
#pragma once

#include <string>
#include <vector>

namespace echolucent::bench {

/// The result of a watched run.
struct WatchedRun {
    double peakMebibytes =
        0.0;                 ///< most memory at any one time, all its processes together, shared memory counted once
    double seconds = 0.0;    ///< from start to end
    bool succeeded = false;  ///< it ended by itself with status 0
};

/// Runs a program (its path, and its arguments). Its output goes where this program's goes. Every few milliseconds its
/// memory is read: the proportional set size (Pss) that Linux gives. The program is ended (SIGTERM) after
/// `mostSeconds`.
[[nodiscard]] WatchedRun watch(const std::vector<std::string>& command, double mostSeconds = 1e9);

}  // namespace echolucent::bench
