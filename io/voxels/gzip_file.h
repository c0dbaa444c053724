// Files that are compressed with gzip as a whole, unpacked into memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/files/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What gzip files begin with.
constexpr std::string_view gzipSignature = "\x1f\x8b\x08";
/// Whether a file begins as gzip files do.
[[nodiscard]] bool looksLikeGzip(std::string_view beginning);
/// The path without ".gz" or ".gzip" at its end; the path itself where it ends otherwise.
[[nodiscard]] std::string withoutGzipEnding(const std::string& path);
/// The most bytes that a file of so many packed bytes is unpacked to: 256 MiB or 32 times the packed bytes, whichever
/// is more, but no more than half of this machine's memory. Echo packs to a half or a third.
[[nodiscard]] std::uint64_t mostUnpackedBytes(std::uint64_t packedBytes);

/// What a gzip file holds, as a file in memory that keeps the name of the packed one. All its members are unpacked, and
/// their checksums and lengths verified. Fails (unreadable) where the file is damaged, ends too early or unpacks to
/// more than mostUnpackedBytes(); (cancelled) where the person ended it. `progress` reports shares from 0 to 1.
[[nodiscard]] Result<InputFile> unpackGzip(const InputFile& packed, const Progress& progress);

}  // namespace echolucent
