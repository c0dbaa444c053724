// Random changes of bytes. The same seed gives the same changes on every machine.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// One to four changes of `bytes`: bits and bytes set; parts cut off, left out, put in, repeated and exchanged. Half of
/// the places lie in the first 512 bytes, the usual place of headers.
[[nodiscard]] std::string mutated(const std::string& bytes, std::uint64_t seed);

}  // namespace echolucent
