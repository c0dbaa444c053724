// How a long computation reports its progress and learns that nobody wants its result any more.
#pragma once

#include <atomic>
#include <functional>

namespace echolucent {

struct CoarseVolume;

/// The caller passes a Progress to the algorithm. The algorithm only polls and reports, and knows no thread.
struct Progress {
    /// Called now and then from the computing thread, with the share done in [0,1]. May be empty.
    std::function<void(double)> report;
    /// Another thread sets the flag to end the computation early. May be null.
    const std::atomic<bool>* cancel = nullptr;
    /// A reader of a large volume calls `coarse` at most once, with every n-th voxel of the first phase
    /// (processing/volume/coarse_grid.h). The reader then reads on. Reading may still fail afterwards. May be empty.
    std::function<void(const CoarseVolume&)> coarse{};

    [[nodiscard]] bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
    void at(double share) const {
        if (report) report(share);
    }
};

/// The progress of a part of a computation. The part goes from the share `from` of `whole` to the share `to`, both in
/// [0,1], and reports to `whole`. `cancel` and `coarse` are those of `whole`, which must outlive the part.
[[nodiscard]] inline Progress partOf(const Progress& whole, double from, double to) {
    Progress part = whole;
    if (whole.report) part.report = [&whole, from, to](double share) { whole.at(from + share * (to - from)); };
    return part;
}

}  // namespace echolucent
