#include "app/study/freed_elsewhere.h"

#include <condition_variable>
#include <mutex>
#include <vector>

namespace echolucent {

struct WaitingToBeFreed::Parts {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<std::shared_ptr<const void>> references;
    bool toEnd = false, hasEnded = false;
};

WaitingToBeFreed::WaitingToBeFreed() : m_parts(std::make_unique<Parts>()) {}

WaitingToBeFreed::~WaitingToBeFreed() = default;

void WaitingToBeFreed::add(std::shared_ptr<const void> last) noexcept {
    try {
        const std::lock_guard lock(m_parts->mutex);
        if (m_parts->hasEnded) return;
        m_parts->references.push_back(std::move(last));
    } catch (const std::exception&) {
        return;
    }
    m_parts->changed.notify_all();
}

void WaitingToBeFreed::letGoUntilEnd() {
    while (true) {
        std::vector<std::shared_ptr<const void>> taken;
        {
            std::unique_lock lock(m_parts->mutex);
            m_parts->changed.wait(lock, [this] { return !m_parts->references.empty() || m_parts->toEnd; });
            m_parts->hasEnded = m_parts->references.empty();
            if (m_parts->hasEnded) return;
            taken.swap(m_parts->references);
        }
        // Not under the lock: it takes long, and a freed object may add another one.
        taken.clear();
    }
}

void WaitingToBeFreed::end() {
    {
        const std::lock_guard lock(m_parts->mutex);
        m_parts->toEnd = true;
    }
    m_parts->changed.notify_all();
}

FreeingThread::FreeingThread() : m_thread([waiting = m_waiting] { waiting->letGoUntilEnd(); }) {}

FreeingThread::~FreeingThread() {
    m_waiting->end();
    m_thread.join();
}

const FreeingThread& freeingThread() {
    static const FreeingThread thread;
    return thread;
}

}  // namespace echolucent
