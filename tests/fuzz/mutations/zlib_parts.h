// Packs and unpacks, for mutations of packed files.
#pragma once

#include <string>
#include <string_view>

namespace echolucent {

/// zlib's windowBits: raw deflate as in DICOM, and gzip.
inline constexpr int rawWindow = -15, gzipWindow = 31;

/// The contents of a stream, as far as it can be unpacked; 4 MiB at most.
[[nodiscard]] std::string unpacked(std::string_view bytes, int windowBits);
/// The bytes as a stream.
[[nodiscard]] std::string packed(std::string_view bytes, int windowBits);

}  // namespace echolucent
