// How a long computation says how far it is and learns that nobody wants its result any more.
#pragma once

#include <atomic>
#include <functional>

namespace echolucent {

/// The caller hands it down. The algorithm only polls and reports; it knows no thread.
struct Progress {
    /// Called now and then with the share done, in [0,1], from the computing thread; may be empty.
    std::function<void(double)> report;
    /// Raised by another thread to end the computation early; may be null.
    const std::atomic<bool>* cancel = nullptr;

    [[nodiscard]] bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
    void at(double share) const {
        if (report) report(share);
    }
};

}  // namespace echolucent
