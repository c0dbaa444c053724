#include "processing/volume/bit_grid.h"

#include <algorithm>
#include <bit>

#include "processing/volume/grid_rows.h"

namespace echolucent {

namespace {

constexpr std::int64_t rowsOfBits = 256;  ///< rows that one thread takes at a time

/// The bits that exist in the last word of a row.
std::uint64_t lastWordMask(std::int64_t sizeX) {
    return sizeX % 64 == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << (sizeX % 64)) - 1;
}

/// Spreads the members of `row` along x in both directions, through runs of `passable` bits.
void spreadAlongRow(std::uint64_t* row, const std::uint64_t* passable, std::int64_t words) {
    std::uint64_t carry = 0;
    const auto fill = [&](std::int64_t i, std::uint64_t entering) {
        // Spreads members by 1, 2, 4, … 32 bits at once, through runs of at least this many passable bits.
        std::uint64_t upwards = passable[i], downwards = passable[i];
        std::uint64_t filled = (row[i] | entering) & passable[i];
        for (int shift = 1; shift < 64; shift *= 2) {
            filled |= upwards & (filled << shift);
            upwards &= upwards << shift;
        }
        for (int shift = 1; shift < 64; shift *= 2) {
            filled |= downwards & (filled >> shift);
            downwards &= downwards >> shift;
        }
        row[i] = filled;
    };
    for (std::int64_t i = 0; i < words; ++i) {
        fill(i, carry);
        carry = row[i] >> 63;
    }
    carry = 0;
    for (std::int64_t i = words - 1; i >= 0; --i) {
        fill(i, carry);
        carry = row[i] << 63;
    }
}

}  // namespace

BitGrid::BitGrid(const std::array<std::int64_t, 3>& size)
    : m_size(size), m_words((size[0] + 63) / 64), m_bits(static_cast<std::size_t>(m_words * size[1] * size[2])) {}

std::int64_t BitGrid::count() const {
    std::int64_t members = 0;
    for (const std::uint64_t word : m_bits) members += std::popcount(word);
    return members;
}

BitGrid BitGrid::operator&(const BitGrid& other) const {
    BitGrid result = *this;
    for (std::size_t i = 0; i < m_bits.size(); ++i) result.m_bits[i] &= other.m_bits[i];
    return result;
}

BitGrid BitGrid::operator|(const BitGrid& other) const {
    BitGrid result = *this;
    for (std::size_t i = 0; i < m_bits.size(); ++i) result.m_bits[i] |= other.m_bits[i];
    return result;
}

BitGrid BitGrid::dilated() const {
    BitGrid result = *this;
    const std::uint64_t lastMask = lastWordMask(m_size[0]);
    forEachRow(m_size, rowsOfBits, [&](std::int64_t y, std::int64_t z) {
        const std::uint64_t* own = row(y, z);
        std::uint64_t* target = result.row(y, z);
        for (std::int64_t i = 0; i < m_words; ++i) {
            target[i] |= own[i] << 1 | own[i] >> 1;
            if (i > 0) target[i] |= own[i - 1] >> 63;
            if (i + 1 < m_words) target[i] |= own[i + 1] << 63;
            if (y > 0) target[i] |= row(y - 1, z)[i];
            if (y + 1 < m_size[1]) target[i] |= row(y + 1, z)[i];
            if (z > 0) target[i] |= row(y, z - 1)[i];
            if (z + 1 < m_size[2]) target[i] |= row(y, z + 1)[i];
        }
        target[m_words - 1] &= lastMask;
    });
    return result;
}

BitGrid BitGrid::eroded() const {
    BitGrid result = *this;
    const std::uint64_t beyondLast = ~lastWordMask(m_size[0]);
    const auto word = [&](const std::uint64_t* own, std::int64_t i) {
        if (i < 0 || i >= m_words) return ~std::uint64_t{0};
        return i == m_words - 1 ? own[i] | beyondLast : own[i];
    };
    forEachRow(m_size, rowsOfBits, [&](std::int64_t y, std::int64_t z) {
        const std::uint64_t* own = row(y, z);
        std::uint64_t* target = result.row(y, z);
        for (std::int64_t i = 0; i < m_words; ++i) {
            const std::uint64_t here = word(own, i);
            target[i] &= (here << 1 | word(own, i - 1) >> 63) & (here >> 1 | word(own, i + 1) << 63);
            if (y > 0) target[i] &= row(y - 1, z)[i];
            if (y + 1 < m_size[1]) target[i] &= row(y + 1, z)[i];
            if (z > 0) target[i] &= row(y, z - 1)[i];
            if (z + 1 < m_size[2]) target[i] &= row(y, z + 1)[i];
        }
    });
    return result;
}

BitGrid BitGrid::connectedToBorder() const {
    BitGrid result(m_size);
    std::vector<std::int64_t> waiting;  // rows that hold new members
    const std::int64_t rows = m_size[1] * m_size[2];
    const std::uint64_t lastBit = std::uint64_t{1} << ((m_size[0] - 1) % 64);
    for (std::int64_t index = 0; index < rows; ++index) {
        const std::int64_t y = index % m_size[1], z = index / m_size[1];
        const std::uint64_t* open = row(y, z);
        std::uint64_t* seeds = result.row(y, z);
        const bool onBorder = y == 0 || y == m_size[1] - 1 || z == 0 || z == m_size[2] - 1;
        if (onBorder) std::copy_n(open, m_words, seeds);
        seeds[0] |= open[0] & 1;
        seeds[m_words - 1] |= open[m_words - 1] & lastBit;
        spreadAlongRow(seeds, open, m_words);
        if (std::any_of(seeds, seeds + m_words, [](std::uint64_t word) { return word != 0; })) waiting.push_back(index);
    }
    const auto enter = [&](std::int64_t y, std::int64_t z, const std::uint64_t* from) {
        if (y < 0 || y >= m_size[1] || z < 0 || z >= m_size[2]) return;
        std::uint64_t* target = result.row(y, z);
        const std::uint64_t* open = row(y, z);
        bool entered = false;
        for (std::int64_t i = 0; i < m_words; ++i) {
            const std::uint64_t added = from[i] & open[i] & ~target[i];
            target[i] |= added;
            entered |= added != 0;
        }
        if (!entered) return;
        spreadAlongRow(target, open, m_words);
        waiting.push_back(z * m_size[1] + y);
    };
    while (!waiting.empty()) {
        const std::int64_t index = waiting.back(), y = index % m_size[1], z = index / m_size[1];
        waiting.pop_back();
        const std::uint64_t* from = result.row(y, z);
        enter(y - 1, z, from);
        enter(y + 1, z, from);
        enter(y, z - 1, from);
        enter(y, z + 1, from);
    }
    return result;
}

}  // namespace echolucent
