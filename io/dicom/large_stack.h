// Threads for the DICOM library, which recurses where data sets nest and when it frees them.
#pragma once

#include <cstddef>
#include <functional>

namespace echolucent {

/// Runs `work` in a thread of its own with a large stack and waits for it; exceptions come back to the caller.
void runWithLargeStack(const std::function<void()>& work);

/// Runs `work(0)` ... `work(count - 1)`, each once, on as many threads with large stacks as there are processors, and
/// waits for them; the first exception comes back to the caller. `share` is called between pieces, from one thread at a
/// time, with the share done in [0,1].
void runEachWithLargeStack(std::size_t count, const std::function<void(std::size_t)>& work,
                           const std::function<void(double)>& share);

}  // namespace echolucent
