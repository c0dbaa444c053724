#include "io/voxels/voxel_bytes.h"

#include <atomic>
#include <cstdlib>

namespace echolucent {

namespace {

/// This process's own memory. The system hands out large pieces as zeros, so nothing writes zeros again.
class ZeroedHeap : public std::pmr::memory_resource {
    void* do_allocate(std::size_t bytes, std::size_t) override {
        void* const memory = std::calloc(bytes, 1);
        if (memory == nullptr) throw std::bad_alloc();
        return memory;
    }
    void do_deallocate(void* memory, std::size_t, std::size_t) override { std::free(memory); }
    [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
        return this == &other;
    }
};

std::atomic<std::pmr::memory_resource*>& chosenMemory() {
    // Never destroyed, because voxels may be freed after everything else.
    static auto* const heap = new ZeroedHeap;
    static std::atomic<std::pmr::memory_resource*> memory{heap};
    return memory;
}

}  // namespace

std::pmr::memory_resource& voxelMemory() { return *chosenMemory(); }

void setVoxelMemory(std::pmr::memory_resource& memory) { chosenMemory() = &memory; }

}  // namespace echolucent
