// The walk through a folder and those below it: what is looked at, and what is said of the rest.
#pragma once

#include <string>
#include <vector>

#include "processing/progress.h"

namespace echolucent {

/// The files in and below a folder.
struct FilesBelow {
    std::vector<std::string> paths;     ///< in the order of their names
    std::vector<std::string> warnings;  ///< sentences on what was not looked at
};
/// All files in a folder and in those below it down to `deepest`, 50,000 at most, and those out of it that links lead
/// to. Links to what lies in the folder are left out, because it is met there anyway, and so are links to other
/// folders. A warning tells of links that lead out or nowhere, of pipes, sockets and devices, of folders further down
/// and of those that may not be read. `progress` is polled for cancel at each entry; what was found until then comes
/// back.
[[nodiscard]] FilesBelow walkFilesBelow(const std::string& folder, int deepest, const Progress& progress);

/// The names of files for one sentence, without the folders above them: the first three in quotes, and how many more
/// there are. `paths` holds one at least.
[[nodiscard]] std::string filesInWords(const std::vector<std::string>& paths);

}  // namespace echolucent
