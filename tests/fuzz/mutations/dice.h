// Numbers from a seed. Mutations are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace echolucent {

/// A sequence of numbers that depends on its seed alone (SplitMix64). The standard library's distributions differ
/// between compilers.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : m_state(seed) {}
    [[nodiscard]] std::uint64_t number() {
        m_state += 0x9e3779b97f4a7c15ULL;
        std::uint64_t mixed = m_state;
        mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
        return mixed ^ (mixed >> 31);
    }
    /// A number from 0 to `end` - 1; `end` is above 0.
    [[nodiscard]] std::size_t below(std::size_t end) { return static_cast<std::size_t>(number() % end); }
    /// True once in `times`, which is above 0.
    [[nodiscard]] bool oneIn(std::size_t times) { return below(times) == 0; }
    /// One of at least one value.
    template <typename Values>
    [[nodiscard]] auto& oneOf(Values& values) {
        return *(std::begin(values) + static_cast<std::ptrdiff_t>(below(std::size(values))));
    }

private:
    std::uint64_t m_state;
};

}  // namespace echolucent
