#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace echolucent {

/// Values one after the other that never change. Copies share them, across threads too. They may lie in a vector or in
/// memory that another process filled.
template <typename Value>
class VoxelArray {
public:
    using value_type = Value;

    VoxelArray() = default;
    /// Takes a vector. It converts implicitly, so that voxels can be computed in vectors.
    VoxelArray(std::vector<Value> values) {
        auto owner = std::make_shared<const std::vector<Value>>(std::move(values));
        m_values = *owner;
        m_owner = std::move(owner);
    }
    VoxelArray(std::initializer_list<Value> values) : VoxelArray(std::vector<Value>(values)) {}
    /// Values in memory that `owner` keeps. With a null owner, the caller keeps the memory as long as a copy of this
    /// array lives. Nothing may write to the values meanwhile.
    VoxelArray(std::shared_ptr<const void> owner, std::span<const Value> values)
        : m_owner(std::move(owner)), m_values(values) {}

    [[nodiscard]] std::size_t size() const { return m_values.size(); }
    [[nodiscard]] bool empty() const { return m_values.empty(); }
    [[nodiscard]] const Value* data() const { return m_values.data(); }
    [[nodiscard]] const Value* begin() const { return m_values.data(); }
    [[nodiscard]] const Value* end() const { return m_values.data() + m_values.size(); }
    /// The value at an index below size().
    [[nodiscard]] const Value& operator[](std::size_t index) const { return m_values[index]; }
    [[nodiscard]] const Value& front() const { return m_values.front(); }
    [[nodiscard]] const Value& back() const { return m_values.back(); }
    /// A copy that can be changed.
    [[nodiscard]] std::vector<Value> toVector() const { return {begin(), end()}; }

    /// Whether the values are the same, wherever they lie.
    friend bool operator==(const VoxelArray& one, const VoxelArray& other) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end());
    }

private:
    std::shared_ptr<const void> m_owner;
    std::span<const Value> m_values;
};

/// The voxel types kept in memory. Readers convert every other type into one of them, without loss if possible (int8
/// and int16 without negative values become unsigned). The import report tells of any loss.
using Voxels = std::variant<VoxelArray<std::uint8_t>, VoxelArray<std::uint16_t>, VoxelArray<float>>;

/// One byte for each voxel: 1 is data, 0 is none. If it is empty, all voxels are data.
using DataMask = VoxelArray<std::uint8_t>;

}  // namespace echolucent
