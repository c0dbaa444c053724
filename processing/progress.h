// How a long computation reports its progress and learns that nobody wants its result any more.
#pragma once

#include <atomic>
#include <functional>

namespace echolucent {

struct CoarseVolume;

/// The caller passes it to the algorithm. The algorithm only polls and reports, and knows no thread.
struct Progress {
    /// Called now and then from the computing thread, with the share done in [0,1]. May be empty.
    std::function<void(double)> report;
    /// Another thread sets it to end the computation early. May be null.
    const std::atomic<bool>* cancel = nullptr;
    /// A reader of a large volume calls it at most once, before it reads on. It passes every n-th voxel of the first
    /// phase (processing/volume/coarse_grid.h). Reading may still fail afterwards. May be empty.
    std::function<void(const CoarseVolume&)> coarse{};

    [[nodiscard]] bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
    void at(double share) const {
        if (report) report(share);
    }
};

/// The progress of a part of a computation. It reports to `whole`, where the part goes from the share `from` to the
/// share `to`, both in [0,1]. `whole` must outlive it.
[[nodiscard]] inline Progress partOf(const Progress& whole, double from, double to) {
    Progress part = whole;
    if (whole.report) part.report = [&whole, from, to](double share) { whole.at(from + share * (to - from)); };
    return part;
}

}  // namespace echolucent
