// Files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "processing/result.h"

namespace echolucent {

/// Writes bytes to a temporary file beside `path` and renames it; a file that is there keeps its permissions, a link
/// stays a link, a device or a pipe is written into. "-" writes to standard output.
[[nodiscard]] Result<void> writeFileAtomically(const std::string& path, std::string_view bytes);

/// Reads a whole file of at most `limit` bytes.
[[nodiscard]] Result<std::string> readWholeFile(const std::string& path, std::size_t limit);

}  // namespace echolucent
