// Changes of files that are packed with gzip.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A packed file with changes: of the packed bytes, or of what they hold, which is packed again with its true checksum.
[[nodiscard]] std::string mutatedGzip(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
