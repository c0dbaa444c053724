// Changes of files that are packed with gzip.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A packed file with changes, either of the packed bytes or of their contents. Contents are packed again with their
/// true checksum.
[[nodiscard]] std::string mutatedGzip(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
