// The progress of a loop on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

#include "processing/progress.h"

namespace echolucent {

/// Counts what all threads have done. Only the thread that made the ProgressCount reports, since the counts of other
/// threads may arrive out of order. The Progress must outlive the ProgressCount.
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
