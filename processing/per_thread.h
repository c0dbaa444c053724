// A value of each thread's own in parallel loops.
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

/// A value of each thread's own, made by `make` when the thread first asks for it. Debian's oneTBB runtime is not
/// instrumented, so that the thread sanitizer would not see how its own such class works.
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

/// A value of each thread's own, made when the thread first asks for it (local()).
template <typename Value>
using PerThread = tbb::enumerable_thread_specific<Value>;

#endif

}  // namespace echolucent
