// Changes of GE Voluson (Kretz) volumes, item by item.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A Kretz volume with up to four changes. Tags, declared lengths and values become extremes or others. Items are
/// doubled, left out, moved or put in. Now and then any bytes change.
[[nodiscard]] std::string mutatedKretz(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
