// Unpacks files that are packed with gzip as a whole, into memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/files/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// The beginning of gzip files.
constexpr std::string_view gzipSignature = "\x1f\x8b\x08";
[[nodiscard]] bool looksLikeGzip(std::string_view beginning);
/// The path without ".gz" or ".gzip" at its end; any other path as it is.
[[nodiscard]] std::string withoutGzipEnding(const std::string& path);
/// The most bytes that may come out of a file of `packedBytes`: 256 MiB or 32 times the packed bytes, whichever is
/// more, but at most half of this machine's memory. (Compression shrinks echo only to a half or a third.)
[[nodiscard]] std::uint64_t mostUnpackedBytes(std::uint64_t packedBytes);

/// Unpacks a gzip file to a file in memory with the same name. All its members are unpacked, and their checksums and
/// lengths verified. Fails (unreadable) if the file is damaged or ends too early, if it unpacks to more than
/// mostUnpackedBytes(), or if there is not enough memory; (cancelled) if the person ended it. `progress` reports shares
/// from 0 to 1.
[[nodiscard]] Result<InputFile> unpackGzip(const InputFile& packed, const Progress& progress);

}  // namespace echolucent
