#include "io/dicom/series/large_stack.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <list>
#include <mutex>

namespace echolucent {

namespace {

// The scan refuses deep nesting. The large stack is for files that DCMTK reads otherwise than the scan. Only touched
// pages cost memory.
constexpr std::size_t stackBytes = std::size_t{256} << 20;

/// A thread with a large stack. The destructor waits for its end. If no thread can be started, the constructor does the
/// work.
class LargeStackThread {
public:
    explicit LargeStackThread(const std::function<void()>& work) : m_work(work) {
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        pthread_attr_setstacksize(&attributes, stackBytes);
        m_started = pthread_create(&m_thread, &attributes, &LargeStackThread::run, this) == 0;
        pthread_attr_destroy(&attributes);
        if (!m_started) run(this);
    }
    LargeStackThread(const LargeStackThread&) = delete;
    LargeStackThread& operator=(const LargeStackThread&) = delete;
    ~LargeStackThread() { wait(); }

    void wait() {
        if (m_started) pthread_join(m_thread, nullptr);
        m_started = false;
    }
    /// What the work threw. Call it after wait().
    [[nodiscard]] std::exception_ptr thrown() const { return m_thrown; }

private:
    static void* run(void* argument) {
        auto& own = *static_cast<LargeStackThread*>(argument);
        try {
            own.m_work();
        } catch (...) {
            own.m_thrown = std::current_exception();
        }
        return nullptr;
    }

    const std::function<void()>& m_work;
    std::exception_ptr m_thrown;
    pthread_t m_thread{};
    bool m_started = false;
};

void runAndRethrow(std::size_t threads, const std::function<void()>& work) {
    std::list<LargeStackThread> running;
    for (std::size_t i = 0; i < threads; ++i) running.emplace_back(work);
    for (LargeStackThread& thread : running) thread.wait();
    for (const LargeStackThread& thread : running)
        if (thread.thrown()) std::rethrow_exception(thread.thrown());
}

}  // namespace

void runWithLargeStack(const std::function<void()>& work) { runAndRethrow(1, work); }

void runEachWithLargeStack(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work,
                           const Progress& progress) {
    std::atomic<std::size_t> next{0}, done{0};
    std::mutex reporting;
    const std::function<void()> pieces = [&] {
        for (std::size_t index = next.fetch_add(1); index < count && !progress.cancelled(); index = next.fetch_add(1)) {
            work(index);
            done.fetch_add(1);
            // Skip the report if another thread reports; the next piece reports again.
            if (const std::unique_lock lock(reporting, std::try_to_lock); lock)
                progress.at(static_cast<double>(done.load()) / static_cast<double>(count));
        }
    };
    runAndRethrow(std::min(threads, count), pieces);
}

}  // namespace echolucent
