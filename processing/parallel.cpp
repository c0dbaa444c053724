#include "processing/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>

#ifdef __SANITIZE_THREAD__
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#endif

namespace echolucent::parallel {

namespace {

#ifdef __SANITIZE_THREAD__

/// Runs a loop on plain threads, for the thread sanitizer. The threads are as many as oneTBB would use here, the
/// caller's among them. Debian's oneTBB runtime is not instrumented: the sanitizer would not see how oneTBB hands work
/// from thread to thread, and would report false races. Each call gets one part of `range` that cannot be split any
/// further.
template <typename Range, typename Call>
void onThreads(const Range& range, const Call& call) {
    std::vector<Range> open{range}, parts;
    while (!open.empty()) {
        if (open.back().is_divisible()) {
            Range second(open.back(), tbb::split{});
            open.push_back(second);
        } else {
            if (!open.back().empty()) parts.push_back(open.back());
            open.pop_back();
        }
    }
    std::atomic<std::size_t> next = 0;
    std::exception_ptr thrown;
    std::mutex mutex;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < parts.size(); i = next++) call(parts[i]);
        } catch (...) {
            next = parts.size();
            const std::lock_guard lock(mutex);
            if (!thrown) thrown = std::current_exception();
        }
    };
    const int atOnce =
        std::min(tbb::this_task_arena::max_concurrency(),
                 static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
    std::vector<std::jthread> threads;
    for (int i = 1; i < std::min(atOnce, static_cast<int>(parts.size())); ++i) threads.emplace_back(work);
    work();
    threads.clear();
    if (thrown) std::rethrow_exception(thrown);
}

#else

template <typename Range, typename Call>
void onThreads(const Range& range, const Call& call) {
    tbb::parallel_for(range, call);
}

#endif

}  // namespace

void forParts(const Part& range, void (*call)(const void* body, const Part& part), const void* body) {
    using Range = tbb::blocked_range<std::int64_t>;
    const auto grain = static_cast<std::size_t>(range.grain());
    onThreads(Range(range.begin(), range.end(), grain), [&](const Range& part) {
        call(body, {part.begin(), part.end(), range.grain()});
    });
}

void forTiles(const Tile& range, void (*call)(const void* body, const Tile& tile), const void* body) {
    using Range = tbb::blocked_range2d<std::int64_t>;
    const auto partOf = [](const auto& indices) { return Part(indices.begin(), indices.end()); };
    onThreads(Range(0, range.rows().end(), 1, 0, range.columns().end(), 1),
              [&](const Range& tile) { call(body, Tile::part(partOf(tile.rows()), partOf(tile.cols()))); });
}

}  // namespace echolucent::parallel
