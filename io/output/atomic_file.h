// Files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "processing/result.h"

namespace echolucent {

/// Writes `bytes` to a temporary file beside `path` and renames it to `path`. A file that is there keeps its
/// permissions, a link stays a link, a device or a pipe is written into. The path "-" means standard output. Fails
/// (unwritable) where that cannot be done; what was at `path` is then as it was.
[[nodiscard]] Result<void> writeFileAtomically(const std::string& path, std::string_view bytes);

}  // namespace echolucent
