// Packing and unpacking for mutations of what is packed.
#pragma once

#include <string>
#include <string_view>

namespace echolucent {

/// zlib's windowBits: raw deflate as in DICOM, and gzip.
inline constexpr int rawWindow = -15, gzipWindow = 31;

/// What a stream holds, as far as it can be unpacked, 4 MiB at most.
[[nodiscard]] std::string unpacked(std::string_view bytes, int windowBits);
/// The bytes as a stream.
[[nodiscard]] std::string packed(std::string_view bytes, int windowBits);

}  // namespace echolucent
