// The bytes of voxels as values of the type that a file stores.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "io/voxels/stored_type.h"
#include "io/voxels/voxel_bytes.h"

namespace echolucent {

/// Calls `visit` with a value of the type that is stored.
template <typename Visit>
auto withStoredType(StoredType type, const Visit& visit) {
    switch (type) {
        case StoredType::uint8: return visit(std::uint8_t{});
        case StoredType::int8: return visit(std::int8_t{});
        case StoredType::uint16: return visit(std::uint16_t{});
        case StoredType::int16: return visit(std::int16_t{});
        case StoredType::uint32: return visit(std::uint32_t{});
        case StoredType::int32: return visit(std::int32_t{});
        case StoredType::uint64: return visit(std::uint64_t{});
        case StoredType::int64: return visit(std::int64_t{});
        case StoredType::float32: return visit(float{});
        case StoredType::float64: break;
    }
    return visit(double{});
}

/// The value at a place among values of T, in this machine's byte order.
template <typename T>
[[nodiscard]] T storedAt(std::span<const std::uint8_t> bytes, std::size_t index) {
    T value;
    std::memcpy(&value, bytes.data() + index * sizeof(T), sizeof(T));
    return value;
}

/// Converts each value with `become`. The values stay in their memory if a To is no larger than a From.
template <typename From, typename To, typename Become>
[[nodiscard]] VoxelArray<To> valuesBecoming(VoxelBytes bytes, const Become& become) {
    const std::size_t count = bytes.size() / sizeof(From);
    VoxelBytes larger;
    if constexpr (sizeof(To) > sizeof(From)) larger.resize(count * sizeof(To));
    VoxelBytes& kept = sizeof(To) > sizeof(From) ? larger : bytes;
    for (std::size_t i = 0; i < count; ++i) {
        const To value = become(storedAt<From>(bytes, i));
        std::memcpy(kept.data() + i * sizeof(To), &value, sizeof(To));
    }
    kept.resize(count * sizeof(To));
    kept.shrink_to_fit();
    return voxelsIn<To>(std::move(kept));
}

}  // namespace echolucent
