// Threads for the DICOM library, which recurses where data sets nest and when it frees them.
#pragma once

#include <cstddef>
#include <functional>

#include "processing/progress.h"

namespace echolucent {

/// Runs `work` in a thread of its own with a large stack and waits for it; exceptions come back to the caller.
void runWithLargeStack(const std::function<void()>& work);

/// Runs `work(0)` ... `work(count - 1)`, each once, on up to `threads` threads (1 or more) with large stacks, and waits
/// for them: parallelFor() runs on threads whose stacks are too small for the DICOM library. The first exception comes
/// back to the caller. `progress` is told the share done from one thread at a time; no piece is begun once it is
/// cancelled.
void runEachWithLargeStack(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work,
                           const Progress& progress);

}  // namespace echolucent
