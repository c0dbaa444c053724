// Values of which each thread has its own in parallel loops.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#else
#include <tbb/enumerable_thread_specific.h>
#endif

namespace echolucent {

#ifdef __SANITIZE_THREAD__

/// A value of each thread's own. `make` makes it when the thread first asks for it. oneTBB has such a class too, but
/// Debian's oneTBB runtime is not instrumented for the thread sanitizer.
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

/// A value of each thread's own. local() makes it when the thread first asks for it.
template <typename Value>
using PerThread = tbb::enumerable_thread_specific<Value>;

#endif

}  // namespace echolucent
