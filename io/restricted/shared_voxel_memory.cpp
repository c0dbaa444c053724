#include "io/restricted/shared_voxel_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <new>

namespace echolucent::restricted {

namespace {

// A large page replaces 512 small ones, if the kernel has them.
constexpr std::uint64_t largePageBytes = std::uint64_t{2} << 20;

std::uint64_t roundedUp(std::uint64_t bytes, std::uint64_t unit) { return (bytes + unit - 1) / unit * unit; }

}  // namespace

SharedVoxelMemory::~SharedVoxelMemory() {
    for (const auto& [start, piece] : m_pieces) munmap(const_cast<std::uint8_t*>(start), piece.bytes);
}

void* SharedVoxelMemory::do_allocate(std::size_t bytes, std::size_t) {
    const std::lock_guard alone(m_access);
    const bool isLarge = bytes >= 2 * largePageBytes;
    Piece piece{isLarge ? roundedUp(m_size, largePageBytes) : m_size,
                roundedUp(bytes > 0 ? bytes : 1, sharedPageBytes)};
    if (!m_memory) m_memory = sharedMemory(0);
    if (!m_memory || ftruncate(m_memory.number(), static_cast<off_t>(piece.offset + piece.bytes)) != 0)
        throw std::bad_alloc();
    void* const start = mmap(nullptr, piece.bytes, PROT_READ | PROT_WRITE, MAP_SHARED, m_memory.number(),
                             static_cast<off_t>(piece.offset));
    if (start == MAP_FAILED) throw std::bad_alloc();
    if (isLarge) {
        madvise(start, piece.bytes, MADV_HUGEPAGE);
        // Ask for all pages at once. A trap into the kernel at each page's first touch takes up to ten times as long.
        // If the kernel cannot do so, it gives them one by one.
        madvise(start, piece.bytes, MADV_POPULATE_WRITE);
    }
    m_size = piece.offset + piece.bytes;
    m_pieces.emplace(static_cast<const std::uint8_t*>(start), piece);
    return start;
}

void SharedVoxelMemory::do_deallocate(void* memory, std::size_t, std::size_t) {
    const std::lock_guard alone(m_access);
    const auto place = m_pieces.find(static_cast<const std::uint8_t*>(memory));
    if (place == m_pieces.end()) return;
    const Piece piece = place->second;
    m_pieces.erase(place);
    munmap(memory, piece.bytes);
    // The kernel takes the pages back; the piece stays a hole.
    if (m_memory)
        fallocate(m_memory.number(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(piece.offset),
                  static_cast<off_t>(piece.bytes));
}

std::optional<std::uint64_t> SharedVoxelMemory::offsetOf(const void* address) const {
    const std::lock_guard alone(m_access);
    const auto* byte = static_cast<const std::uint8_t*>(address);
    auto after = m_pieces.upper_bound(byte);
    if (after == m_pieces.begin()) return std::nullopt;
    const auto& [start, piece] = *--after;
    const auto within = static_cast<std::uint64_t>(byte - start);
    return within < piece.bytes ? std::optional(piece.offset + within) : std::nullopt;
}

std::uint64_t SharedVoxelMemory::size() const {
    const std::lock_guard alone(m_access);
    return m_size;
}

Descriptor SharedVoxelMemory::handOver() {
    const std::lock_guard alone(m_access);
    return std::move(m_memory);
}

}  // namespace echolucent::restricted
