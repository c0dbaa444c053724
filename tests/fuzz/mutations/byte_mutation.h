// Changes bytes of any meaning, and gives extremes for all mutations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "tests/fuzz/mutations/dice.h"

namespace echolucent {

/// The longest result of a mutation, so that a list that is doubled again and again stays bounded.
inline constexpr std::size_t longestMutation = std::size_t{1} << 20;

/// The bytes with one change: bits flipped, the end cut off, or bytes put in, taken out, doubled, moved or set to
/// extremes.
[[nodiscard]] std::string withBytesChanged(std::string bytes, Dice& dice);
/// The same from a seed, with up to four changes.
[[nodiscard]] std::string mutatedBytes(std::string bytes, std::uint64_t seed);

/// A number as text that readers seldom see: "nan", "-1", "1e300", "2147483648", "0x10", "24.9", an empty one.
[[nodiscard]] std::string extremeNumber(Dice& dice);
/// A whole number at the edge of what 8 to 64 bits hold.
[[nodiscard]] std::uint64_t extremeWhole(Dice& dice);
/// A float at an edge: not a number, infinite, 0, -0, the smallest, the largest, one, half.
[[nodiscard]] double extremeReal(Dice& dice);
/// The bytes of a value, reversed if the byte order is the other one.
template <typename Value>
[[nodiscard]] std::string bytesOfValue(Value value, bool reversed = false) {
    const auto* first = reinterpret_cast<const char*>(&value);
    const std::string bytes(first, first + sizeof value);
    return reversed ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}
/// The value whose bytes stand at `offset`; they must be there.
template <typename Value>
[[nodiscard]] Value valueAt(std::string_view bytes, std::size_t offset) {
    Value value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}
/// `width` bytes (1, 2, 4 or 8) with an extreme whole number or, for 4 and 8, an extreme float.
[[nodiscard]] std::string extremeField(Dice& dice, std::size_t width, bool real, bool reversed = false);

}  // namespace echolucent
