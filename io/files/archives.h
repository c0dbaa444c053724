// Archives and packed files, which no reader looks into.
#pragma once

#include <string_view>

namespace echolucent {

/// Whether ten bytes or more begin like bzip2: they say the size of its blocks, and then begin a block or end.
[[nodiscard]] bool looksLikeBzip2(std::string_view beginning);

/// What a file is that has to be unpacked first, by its first 512 bytes: "is a ZIP archive", "is compressed with xz".
/// Empty if it is nothing of the kind, or packed with gzip, which the readers unpack.
[[nodiscard]] std::string_view archiveInWords(std::string_view beginning);

}  // namespace echolucent
