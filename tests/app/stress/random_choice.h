// What a stress chooses by chance, the same for the same seed on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace echolucent {

/// Each action has numbers of its own, which follow from the seed and the action's number alone: an action that takes
/// more numbers than last time changes nothing for those behind it.
class RandomChoice {
public:
    RandomChoice(std::uint64_t seed, std::uint64_t action) : m_numbers(seed * 0x9E3779B97F4A7C15ULL + action) {}

    /// In [0, count); `count` is above 0.
    int below(int count) { return static_cast<int>(m_numbers() % static_cast<std::uint64_t>(count)); }
    /// In [least, largest).
    double between(double least, double largest) {
        const double share = static_cast<double>(m_numbers() >> 11) * 0x1p-53;
        return least + share * (largest - least);
    }
    bool chance(double share) { return between(0, 1) < share; }
    /// An element of a list that is not empty.
    template <typename List>
    decltype(auto) of(List&& list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(std::size(list))))];
    }

private:
    std::mt19937_64 m_numbers;
};

}  // namespace echolucent
