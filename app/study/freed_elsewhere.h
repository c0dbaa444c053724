// Frees memory in a thread of its own.
#pragma once

#include <exception>
#include <memory>
#include <thread>
#include <utility>

namespace echolucent {

/// Objects that wait for a thread to let go of them. The list outlives the thread, for callers who come later.
class WaitingToBeFreed {
public:
    WaitingToBeFreed();
    ~WaitingToBeFreed();
    WaitingToBeFreed(const WaitingToBeFreed&) = delete;
    WaitingToBeFreed& operator=(const WaitingToBeFreed&) = delete;

    /// Takes a reference over and returns at once. If the thread has ended, or memory is short, the caller's thread
    /// frees the object.
    void add(std::shared_ptr<const void> last) noexcept;

private:
    friend class FreeingThread;
    struct Parts;
    void letGoUntilEnd();
    void end();

    std::unique_ptr<Parts> m_parts;
};

/// A thread that lets go of objects, in the order in which they come.
class FreeingThread {
public:
    /// Throws std::system_error if the system has no thread for it.
    FreeingThread();
    /// Waits until all that was given is let go.
    ~FreeingThread();
    FreeingThread(const FreeingThread&) = delete;
    FreeingThread& operator=(const FreeingThread&) = delete;

    [[nodiscard]] const std::shared_ptr<WaitingToBeFreed>& waiting() const { return m_waiting; }

private:
    std::shared_ptr<WaitingToBeFreed> m_waiting = std::make_shared<WaitingToBeFreed>();
    std::thread m_thread;
};

/// The program's only freeing thread. The program joins it at exit. Throws as FreeingThread() does.
[[nodiscard]] const FreeingThread& freeingThread();

/// Returns `value`; once its last reference is dropped, freeingThread() frees it. To free the voxels of 512³ takes tens
/// of milliseconds, and the last owner is often the picture, in the GUI thread. Null stays null. If there is no thread,
/// whoever drops the object frees it.
template <typename Value>
[[nodiscard]] std::shared_ptr<Value> freedElsewhere(std::shared_ptr<Value> value) {
    Value* address = value.get();
    if (address == nullptr) return nullptr;
    std::shared_ptr<WaitingToBeFreed> waiting;
    try {
        waiting = freeingThread().waiting();
    } catch (const std::exception&) {
        return value;
    }
    // Nothing is left in `value`: the caller destroys it, perhaps after the result.
    return {address,
            [kept = std::move(value), waiting = std::move(waiting)](Value*) mutable { waiting->add(std::move(kept)); }};
}

}  // namespace echolucent
