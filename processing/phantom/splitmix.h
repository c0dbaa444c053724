// Random bits by counter. A value depends on its counter alone, so any thread may compute any part.
#pragma once

#include <cstdint>

namespace echolucent {

/// The n-th output of the SplitMix64 generator (Steele, Lea, Flood 2014) as a hash of n.
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

}  // namespace echolucent
