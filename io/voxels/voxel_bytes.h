// The bytes that readers put voxels into. They become voxels without a copy. In the reader process they lie in memory
// that it shares with the workstation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "processing/volume/voxels.h"

namespace echolucent {

/// The memory of VoxelBytes: this process's own, unless another was set. New memory is all 0.
[[nodiscard]] std::pmr::memory_resource& voxelMemory();
/// Sets the memory of all VoxelBytes that are made after the call. `memory` must outlive them all and give only zeros.
void setVoxelMemory(std::pmr::memory_resource& memory);

/// Allocates from voxelMemory(). New elements are not cleared again: writing 0 over 0 would take as long as reading the
/// voxels.
template <typename Value>
class VoxelAllocator {
public:
    using value_type = Value;
    using propagate_on_container_move_assignment = std::true_type;

    VoxelAllocator() : m_memory(&voxelMemory()) {}
    template <typename Other>
    VoxelAllocator(const VoxelAllocator<Other>& other) : m_memory(other.memory()) {}

    [[nodiscard]] Value* allocate(std::size_t count) {
        return static_cast<Value*>(m_memory->allocate(count * sizeof(Value), alignment));
    }
    void deallocate(Value* values, std::size_t count) {
        m_memory->deallocate(values, count * sizeof(Value), alignment);
    }
    template <typename Element, typename... Arguments>
    void construct(Element* element, Arguments&&... arguments) {
        if constexpr (sizeof...(Arguments) > 0) ::new (element) Element(std::forward<Arguments>(arguments)...);
    }
    [[nodiscard]] std::pmr::memory_resource* memory() const { return m_memory; }
    friend bool operator==(const VoxelAllocator& one, const VoxelAllocator& other) {
        return one.m_memory == other.m_memory;
    }

private:
    static constexpr std::size_t alignment = alignof(std::max_align_t);
    std::pmr::memory_resource* m_memory;
};

/// Bytes of voxels. New bytes are 0. Only bytes that a vector gets back after it has shrunk hold what they held.
using VoxelBytes = std::vector<std::uint8_t, VoxelAllocator<std::uint8_t>>;

/// The values in `bytes`, in this machine's byte order, without a copy.
template <typename Value>
[[nodiscard]] VoxelArray<Value> voxelsIn(VoxelBytes bytes) {
    auto owner = std::make_shared<const VoxelBytes>(std::move(bytes));
    const std::span<const Value> values(reinterpret_cast<const Value*>(owner->data()), owner->size() / sizeof(Value));
    return {std::move(owner), values};
}

}  // namespace echolucent
