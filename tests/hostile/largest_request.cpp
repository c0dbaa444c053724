#include "largest_request.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace echolucent {

namespace {

std::atomic<std::size_t> largest{0};

#ifndef __SANITIZE_ADDRESS__
void remember(std::size_t bytes) {
    std::size_t known = largest;
    while (bytes > known && !largest.compare_exchange_weak(known, bytes)) {
    }
}

void* orThrow(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
#endif

}  // namespace

std::size_t largestRequest() { return largest; }
void forgetLargestRequest() { largest = 0; }

}  // namespace echolucent

#ifndef __SANITIZE_ADDRESS__
// The other forms of `new` and `delete` of GCC's library, for arrays and those that do not throw, call these.
void* operator new(std::size_t bytes) {
    echolucent::remember(bytes);
    return echolucent::orThrow(std::malloc(bytes > 0 ? bytes : 1));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    echolucent::remember(bytes);
    void* memory = nullptr;
    return echolucent::orThrow(
        posix_memalign(&memory, static_cast<std::size_t>(alignment), bytes > 0 ? bytes : 1) == 0 ? memory : nullptr);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
#endif
