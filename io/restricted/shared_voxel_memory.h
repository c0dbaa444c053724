// Memory without a name for the reader's voxels. The workstation sees them without a copy.
#pragma once

#include <cstdint>
#include <map>
#include <memory_resource>
#include <mutex>
#include <optional>

#include "io/restricted/channel.h"

namespace echolucent::restricted {

/// Pieces begin at multiples of this many bytes.
inline constexpr std::uint64_t sharedPageBytes = 4096;

/// Gives pieces of one memory without a name, each at the beginning of a page and all 0. Any thread may take pieces and
/// give them back.
class SharedVoxelMemory : public std::pmr::memory_resource {
public:
    SharedVoxelMemory() = default;
    /// Unmaps the pieces that nobody gave back.
    ~SharedVoxelMemory() override;
    SharedVoxelMemory(const SharedVoxelMemory&) = delete;
    SharedVoxelMemory& operator=(const SharedVoxelMemory&) = delete;

    /// Bytes from the beginning of the memory to `address`; no value if no piece holds it.
    [[nodiscard]] std::optional<std::uint64_t> offsetOf(const void* address) const;
    /// Bytes from the beginning of the memory to its end.
    [[nodiscard]] std::uint64_t size() const;
    /// The memory, for the workstation. Pieces that are given back after the call keep their values in it. The
    /// descriptor is not open if no piece was taken.
    [[nodiscard]] Descriptor handOver();

private:
    struct Piece {
        std::uint64_t offset = 0, bytes = 0;
    };
    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
    [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
        return this == &other;
    }

    mutable std::mutex m_access;
    Descriptor m_memory;
    std::uint64_t m_size = 0;
    std::map<const std::uint8_t*, Piece> m_pieces;  ///< by the address of their first byte
};

}  // namespace echolucent::restricted
