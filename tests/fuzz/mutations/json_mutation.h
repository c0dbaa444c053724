// Changes of JSON texts, value by value.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A JSON text with changes: values that are exchanged, removed, renamed, moved, nested or set to extremes where it can
/// be parsed, bytes elsewhere.
[[nodiscard]] std::string mutatedJson(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
