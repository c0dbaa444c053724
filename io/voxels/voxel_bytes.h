// The bytes that readers put voxels into. They become voxels without a copy, and the reader process lets them lie in
// memory that it shares with the workstation.
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

/// Where VoxelBytes are taken from; what it gives is all 0. It is this process's own memory where nobody set another.
[[nodiscard]] std::pmr::memory_resource& voxelMemory();
/// Lets VoxelBytes that begin from now on lie elsewhere; `memory` outlives them all, and what it gives is all 0.
void setVoxelMemory(std::pmr::memory_resource& memory);

/// Takes from voxelMemory(). New elements are left as they are there: a pass that writes 0 over 0 would cost as much
/// time as reading the voxels.
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

/// Bytes of voxels. Those that a new one begins with are 0.
using VoxelBytes = std::vector<std::uint8_t, VoxelAllocator<std::uint8_t>>;

/// The values that bytes hold, in this machine's order of bytes, without a copy.
template <typename Value>
[[nodiscard]] VoxelArray<Value> voxelsIn(VoxelBytes bytes) {
    auto owner = std::make_shared<const VoxelBytes>(std::move(bytes));
    const std::span<const Value> values(reinterpret_cast<const Value*>(owner->data()), owner->size() / sizeof(Value));
    return {std::move(owner), values};
}

}  // namespace echolucent
