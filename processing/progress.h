// How a long computation says how far it is and learns that nobody wants its result any more.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

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

/// Counts for all threads what is done, and reports the share from the thread that made it only: the counts of others
/// may arrive out of order. The progress must outlive it.
class ProgressCount {
public:
    ProgressCount(const Progress& progress, std::size_t total) : m_progress(progress), m_total(total) {}
    void oneDone() {
        const std::size_t done = m_done.fetch_add(1, std::memory_order_relaxed) + 1;
        if (std::this_thread::get_id() == m_caller)
            m_progress.at(static_cast<double>(done) / static_cast<double>(m_total));
    }

private:
    const Progress& m_progress;
    std::size_t m_total;
    std::thread::id m_caller = std::this_thread::get_id();
    std::atomic<std::size_t> m_done{0};
};

}  // namespace echolucent
