// Memory that a thread of its own gives back to the system.
#pragma once

#include <exception>
#include <memory>
#include <thread>
#include <utility>

namespace echolucent {

/// The same object; whoever drops the last reference to it, a thread made for that lets it go. To give back the voxels
/// of 512³ takes tens of milliseconds, and the last one who looks at a volume is often the picture, in the GUI thread.
/// Null stays null.
template <typename Value>
[[nodiscard]] std::shared_ptr<Value> freedElsewhere(std::shared_ptr<Value> value) {
    Value* address = value.get();
    if (address == nullptr) return nullptr;
    return {address, [kept = std::move(value)](Value*) mutable {
                try {
                    std::thread([last = std::move(kept)]() mutable { last.reset(); }).detach();
                } catch (const std::exception&) {
                    // Without another thread it is let go here.
                }
            }};
}

}  // namespace echolucent
