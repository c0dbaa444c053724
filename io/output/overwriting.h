// What keeps an output from taking the place of a file that was read.
#pragma once

#include <string>
#include <vector>

#include "processing/result.h"

namespace echolucent {

/// Fails (wrong usage, naming both files) where one of the `outputs` is the same file as one of the `inputs`. Files are
/// compared by device and inode, so that links and other spellings of a path count. An output that does not exist yet,
/// an empty path and "-" (standard output) pass. It is to be asked before anything is written.
[[nodiscard]] Result<void> refuseToOverwrite(const std::vector<std::string>& inputs,
                                             const std::vector<std::string>& outputs);

}  // namespace echolucent
