#include "random_mutation.h"

#include <algorithm>
#include <array>
#include <random>

namespace echolucent {

namespace {

/// Numbers from a generator that the standard defines to the last bit; its distributions are not.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : m_bits(seed) {}
    /// A number from 0 to count-1; count is above 0.
    std::size_t below(std::size_t count) { return m_bits() % count; }
    char byte() { return static_cast<char>(m_bits() & 0xff); }

private:
    std::mt19937_64 m_bits;
};

void change(std::string& bytes, Dice& dice) {
    if (bytes.empty()) {
        bytes.push_back(dice.byte());
        return;
    }
    const std::size_t near = std::min<std::size_t>(bytes.size(), 512);
    const std::size_t at = dice.below(dice.below(2) == 0 ? near : bytes.size());
    const std::size_t length = std::min(1 + dice.below(dice.below(4) == 0 ? 256 : 8), bytes.size() - at);
    switch (dice.below(9)) {
        case 0: bytes[at] = dice.byte(); break;
        case 1: bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice.below(8))); break;
        case 2: {  // numbers that headers break at
            constexpr std::array<char, 6> edges{'\0', '\xff', '\x7f', '\x80', '-', '9'};
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), std::min<std::size_t>(length, 8),
                        edges.at(dice.below(edges.size())));
            break;
        }
        case 3: bytes.resize(at); break;
        case 4: bytes.erase(at, length); break;
        case 5: {
            std::string inserted;
            for (std::size_t i = 0; i < length; ++i) inserted.push_back(dice.byte());
            bytes.insert(at, inserted);
            break;
        }
        case 6: bytes.insert(at, bytes.substr(at, length)); break;
        case 7: {  // two parts of one length that do not overlap
            const std::size_t other = dice.below(bytes.size());
            const std::size_t apart = at < other ? other - at : at - other;
            const std::size_t count = std::min({length, apart, bytes.size() - at, bytes.size() - other});
            std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                             bytes.begin() + static_cast<std::ptrdiff_t>(at + count),
                             bytes.begin() + static_cast<std::ptrdiff_t>(other));
            break;
        }
        default: {  // a digit, as sizes and spacings of text headers have it
            const auto digit = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(),
                                            [](char letter) { return letter >= '0' && letter <= '9'; });
            if (digit != bytes.end()) *digit = static_cast<char>('0' + dice.below(10));
        }
    }
}

}  // namespace

std::string mutated(const std::string& bytes, std::uint64_t seed) {
    Dice dice(seed);
    std::string other = bytes;
    for (std::size_t i = 1 + dice.below(4); i > 0; --i) change(other, dice);
    return other;
}

}  // namespace echolucent
