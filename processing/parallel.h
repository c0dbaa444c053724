// Parallel loops: oneTBB's. Under the thread sanitizer they run on plain threads instead, because Debian's oneTBB
// runtime is not instrumented: the sanitizer would not see how it hands work from thread to thread, and would report
// races where there are none.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#ifdef __SANITIZE_THREAD__
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>
#endif

namespace echolucent {

#ifdef __SANITIZE_THREAD__

/// Calls `body` on every smallest part of `range`, on as many threads as oneTBB would use here; the caller's is one of
/// them. What `body` throws first is thrown to the caller once all threads have ended.
template <typename Range, typename Body>
void parallelFor(const Range& range, const Body& body) {
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
            for (std::size_t i = next++; i < parts.size(); i = next++) body(parts[i]);
        } catch (...) {
            next = parts.size();
            const std::lock_guard lock(mutex);
            if (!thrown) thrown = std::current_exception();
        }
    };
    const int atOnce = tbb::this_task_arena::max_concurrency();
    std::vector<std::jthread> threads;
    for (int i = 1; i < std::min(atOnce, static_cast<int>(parts.size())); ++i) threads.emplace_back(work);
    work();
    threads.clear();
    if (thrown) std::rethrow_exception(thrown);
}

/// A value of each thread's own, made by `make` when the thread first asks for it.
template <typename Value>
class PerThread {
public:
    explicit PerThread(std::function<Value()> make) : m_make(std::move(make)) {}
    [[nodiscard]] Value& local() {
        const std::lock_guard lock(m_mutex);
        const auto found = m_values.find(std::this_thread::get_id());
        return found != m_values.end() ? found->second
                                       : m_values.emplace(std::this_thread::get_id(), m_make()).first->second;
    }

private:
    std::function<Value()> m_make;
    std::mutex m_mutex;
    std::map<std::thread::id, Value> m_values;
};

#else

/// Calls `body` on parts of `range` (a tbb::blocked_range or blocked_range2d) that together are the whole, on the
/// threads of oneTBB's arena, the caller's among them.
template <typename Range, typename Body>
void parallelFor(const Range& range, const Body& body) {
    tbb::parallel_for(range, body);
}

/// A value of each thread's own, made when the thread first asks for it (local()).
template <typename Value>
using PerThread = tbb::enumerable_thread_specific<Value>;

#endif

/// Calls body(index) for every index of [first, last).
template <typename Index, typename Body>
void parallelFor(Index first, Index last, const Body& body) {
    if (first >= last) return;
    parallelFor(tbb::blocked_range<Index>(first, last), [&](const tbb::blocked_range<Index>& part) {
        for (Index index = part.begin(); index < part.end(); ++index) body(index);
    });
}

}  // namespace echolucent
