// Threads for DCMTK, which recurses into nested data sets, also when it frees them.
#pragma once

#include <cstddef>
#include <functional>

#include "processing/progress.h"

namespace echolucent {

/// Runs `work` in a thread with a large stack and waits for it. If no thread can be started, the caller's thread runs
/// it. Exceptions come back to the caller.
void runWithLargeStack(const std::function<void()>& work);

/// Runs `work(0)` ... `work(count - 1)`, each once, on up to `threads` threads (1 or more) with large stacks, and waits
/// for them. The threads of parallelFor() have stacks too small for DCMTK. The first exception comes back to the
/// caller. `progress` is told the share done, by one thread at a time; the last report may lie below 1. After a cancel
/// no piece begins.
void runEachWithLargeStack(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work,
                           const Progress& progress);

}  // namespace echolucent
