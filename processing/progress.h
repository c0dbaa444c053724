// How a long computation says how far it is and learns that nobody wants its result any more.
#pragma once

#include <atomic>
#include <functional>

namespace echolucent {

struct CoarseVolume;

/// The caller hands it down. The algorithm only polls and reports; it knows no thread.
struct Progress {
    /// Called now and then with the share done, in [0,1], from the computing thread; may be empty.
    std::function<void(double)> report;
    /// Raised by another thread to end the computation early; may be null.
    const std::atomic<bool>* cancel = nullptr;
    /// Called at most once by a reader of a large volume, before it reads on, with every n-th voxel of the first phase
    /// (processing/volume/coarse_grid.h); may be empty. Reading may fail all the same.
    std::function<void(const CoarseVolume&)> coarse{};

    [[nodiscard]] bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
    void at(double share) const {
        if (report) report(share);
    }
};

/// Of a part of a computation: what it reports as shares of the part goes to `whole`, from the share `from` of the
/// whole to the share `to`, both in [0,1]. `whole` must outlive it.
[[nodiscard]] inline Progress partOf(const Progress& whole, double from, double to) {
    Progress part = whole;
    if (whole.report) part.report = [&whole, from, to](double share) { whole.at(from + share * (to - from)); };
    return part;
}

}  // namespace echolucent
