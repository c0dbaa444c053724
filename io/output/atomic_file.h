// Files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// Writes `bytes` to a file that has no name before it is whole, and then takes the place of `path`; where the file
/// system has no such files, to a temporary file beside `path` that is renamed. A file that is there keeps its
/// permissions, a link stays a link. The path "-" means standard output, as do /dev/stdout and its like
/// (placeOfOutput()). Fails as placeOfOutput() does for a file of this kind, and (unwritable) where it cannot be
/// written; what was at `path` is then as it was.
[[nodiscard]] Result<void> writeFileAtomically(const std::string& path, std::string_view bytes,
                                               OutputKind kind = OutputKind::other);

}  // namespace echolucent
