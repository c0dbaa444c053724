// Changes of JSON texts, value by value.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A JSON text with changes. If it can be parsed, values are exchanged, removed, renamed, moved, nested or set to
/// extremes. Else bytes change.
[[nodiscard]] std::string mutatedJson(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
