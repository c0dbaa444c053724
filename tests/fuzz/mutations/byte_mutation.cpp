#include "tests/fuzz/mutations/byte_mutation.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

namespace echolucent {

namespace {

std::size_t placeIn(const std::string& bytes, Dice& dice) { return dice.below(bytes.size() + 1); }

std::string flipped(std::string bytes, Dice& dice) {
    const std::size_t times = 1 + dice.below(4);
    for (std::size_t i = 0; i < times; ++i) bytes[dice.below(bytes.size())] ^= static_cast<char>(1 << dice.below(8));
    return bytes;
}

/// A part of the bytes, put in once more at another place.
std::string doubled(std::string bytes, Dice& dice) {
    const std::size_t from = dice.below(bytes.size());
    const std::string part = bytes.substr(from, 1 + dice.below(64));
    return bytes.insert(placeIn(bytes, dice), part);
}

std::string overwritten(std::string bytes, const std::string& with, Dice& dice) {
    const std::size_t at = dice.below(bytes.size());
    return bytes.replace(at, std::min(with.size(), bytes.size() - at), with);
}

}  // namespace

std::uint64_t extremeWhole(Dice& dice) {
    static constexpr std::array<std::uint64_t, 24> edges{0,
                                                         1,
                                                         2,
                                                         3,
                                                         7,
                                                         8,
                                                         127,
                                                         128,
                                                         255,
                                                         256,
                                                         1024,
                                                         4096,
                                                         32767,
                                                         32768,
                                                         65535,
                                                         65536,
                                                         0x7fffffffU,
                                                         0x80000000U,
                                                         0xfffffffeU,
                                                         0xffffffffU,
                                                         0x100000000U,
                                                         0x7fffffffffffffffU,
                                                         0x8000000000000000U,
                                                         0xffffffffffffffffU};
    return dice.oneIn(8) ? dice.number() : dice.oneOf(edges);
}

double extremeReal(Dice& dice) {
    using Limits = std::numeric_limits<double>;
    static constexpr std::array<double, 20> edges{Limits::quiet_NaN(),
                                                  Limits::infinity(),
                                                  -Limits::infinity(),
                                                  0.0,
                                                  -0.0,
                                                  1.0,
                                                  -1.0,
                                                  0.5,
                                                  -0.3,
                                                  1e-300,
                                                  1e300,
                                                  -1e300,
                                                  Limits::denorm_min(),
                                                  Limits::max(),
                                                  3.5e38,
                                                  1e-30,
                                                  2147483648.0,
                                                  9223372036854775808.0,
                                                  24.9,
                                                  90.0};
    return dice.oneOf(edges);
}

std::string extremeNumber(Dice& dice) {
    static constexpr std::array<std::string_view, 36> edges{"nan",
                                                            "inf",
                                                            "-inf",
                                                            "-1",
                                                            "0",
                                                            "-0",
                                                            "1",
                                                            "2",
                                                            "3",
                                                            "1e300",
                                                            "-1e300",
                                                            "1e-300",
                                                            "1e999",
                                                            "3.5e38",
                                                            "1e-40",
                                                            "0.0000001",
                                                            "24.9",
                                                            "0x10",
                                                            "1,5",
                                                            "127",
                                                            "255",
                                                            "256",
                                                            "32768",
                                                            "65535",
                                                            "65536",
                                                            "2147483647",
                                                            "2147483648",
                                                            "4294967295",
                                                            "4294967296",
                                                            "9223372036854775807",
                                                            "9223372036854775808",
                                                            "18446744073709551615",
                                                            "99999999999999999999999",
                                                            "",
                                                            " ",
                                                            "one"};
    return std::string(dice.oneOf(edges));
}

std::string extremeField(Dice& dice, std::size_t width, bool real, bool reversed) {
    if (real && width == 8) return bytesOfValue(extremeReal(dice), reversed);
    if (real && width == 4) {
        const double value = extremeReal(dice);
        const bool fits = !(value > 3.4e38) && !(value < -3.4e38);
        return bytesOfValue(fits ? static_cast<float>(value) : std::numeric_limits<float>::max(), reversed);
    }
    const std::string whole = bytesOfValue(extremeWhole(dice));
    std::string low = whole.substr(0, width);
    if (reversed) std::reverse(low.begin(), low.end());
    return low;
}

std::string withBytesChanged(std::string bytes, Dice& dice) {
    if (bytes.empty()) return extremeField(dice, 8, false);
    static constexpr std::array<std::size_t, 4> widths{1, 2, 4, 8};
    switch (dice.below(8)) {
        case 0: return flipped(std::move(bytes), dice);
        case 1: return overwritten(std::move(bytes), extremeField(dice, dice.oneOf(widths), dice.oneIn(3)), dice);
        case 2: return overwritten(std::move(bytes), extremeNumber(dice), dice);
        case 3: return bytes.insert(placeIn(bytes, dice), extremeNumber(dice));
        case 4: return bytes.erase(dice.below(bytes.size()), 1 + dice.below(16));
        case 5: return doubled(std::move(bytes), dice);
        case 6: return bytes.insert(placeIn(bytes, dice), 1 + dice.below(16), static_cast<char>(dice.below(256)));
        default: return bytes.substr(0, dice.below(bytes.size()));
    }
}

std::string mutatedBytes(std::string bytes, std::uint64_t seed) {
    Dice dice(seed);
    const std::size_t changes = 1 + dice.below(4);
    for (std::size_t i = 0; i < changes; ++i) bytes = withBytesChanged(std::move(bytes), dice);
    if (bytes.size() > longestMutation) bytes.resize(longestMutation);
    return bytes;
}

}  // namespace echolucent
