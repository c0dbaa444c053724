// A set of voxels, one bit each, with the neighbourhood operations that finding regions needs.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace echolucent {

/// Rows along x are packed into 64-bit words. Voxels are neighbours if they share a face. Most operations pass once
/// over the words; connectedToBorder() passes a row again whenever members enter it. Operands have the same size.
class BitGrid {
public:
    explicit BitGrid(const std::array<std::int64_t, 3>& size);

    [[nodiscard]] const std::array<std::int64_t, 3>& size() const { return m_size; }
    [[nodiscard]] bool at(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return (row(y, z)[x / 64] >> (x % 64) & 1) != 0;
    }
    void set(std::int64_t x, std::int64_t y, std::int64_t z) { row(y, z)[x / 64] |= std::uint64_t{1} << (x % 64); }
    [[nodiscard]] std::int64_t count() const;
    [[nodiscard]] std::int64_t words() const { return m_words; }
    [[nodiscard]] std::uint64_t* row(std::int64_t y, std::int64_t z) { return &m_bits[index(y, z)]; }
    [[nodiscard]] const std::uint64_t* row(std::int64_t y, std::int64_t z) const { return &m_bits[index(y, z)]; }

    /// The members and their six neighbours.
    [[nodiscard]] BitGrid dilated() const;
    /// The members whose six neighbours are members. Voxels outside the grid count as members.
    [[nodiscard]] BitGrid eroded() const;
    [[nodiscard]] BitGrid operator&(const BitGrid& other) const;
    [[nodiscard]] BitGrid operator|(const BitGrid& other) const;

    /// The members connected to the grid's border through members.
    [[nodiscard]] BitGrid connectedToBorder() const;

private:
    [[nodiscard]] std::size_t index(std::int64_t y, std::int64_t z) const {
        return static_cast<std::size_t>((z * m_size[1] + y) * m_words);
    }

    std::array<std::int64_t, 3> m_size;
    std::int64_t m_words;               ///< number of words of one row
    std::vector<std::uint64_t> m_bits;  ///< the bits beyond a row's end are 0
};

}  // namespace echolucent
