// Changes of GE Voluson (Kretz) volumes, item by item.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A Kretz volume with up to four changes: tags, declared lengths and values of items that become extremes or others,
/// items that are doubled, left out, put elsewhere or put in; now and then any bytes.
[[nodiscard]] std::string mutatedKretz(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
