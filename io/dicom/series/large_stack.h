// Threads for the DICOM library, which recurses where data sets nest and when it frees them.
#pragma once

#include <cstddef>
#include <functional>

#include "processing/progress.h"

namespace echolucent {

/// Runs `work` in a thread of its own with a large stack and waits for it; exceptions come back to the caller.
void runWithLargeStack(const std::function<void()>& work);

/// Runs `work(0)` ... `work(count - 1)`, each once, on as many threads with large stacks as there are processors, and
/// waits for them; the first exception comes back to the caller. `progress` is told the share done from one thread at a
/// time; no piece is begun once it is cancelled.
void runEachWithLargeStack(std::size_t count, const std::function<void(std::size_t)>& work, const Progress& progress);

}  // namespace echolucent
