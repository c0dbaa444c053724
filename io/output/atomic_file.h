// Files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// Writes `bytes` to a file without a name, which takes the place of `path` when it is whole. If the file system has no
/// such files, a temporary file beside `path` is renamed instead. An existing file keeps its permissions, and a link
/// stays a link. "-", /dev/stdout and the like are descriptors (placeOfOutput()). Fails as placeOfOutput() does for
/// this kind, and (unwritable) if it cannot be written; a file at `path` is then as it was, but a descriptor may have
/// got some bytes.
[[nodiscard]] Result<void> writeFileAtomically(const std::string& path, std::string_view bytes,
                                               OutputKind kind = OutputKind::other);

}  // namespace echolucent
