// Lists the files in a folder and the folders below it, and says what it left out.
#pragma once

#include <string>
#include <vector>

#include "processing/progress.h"

namespace echolucent {

/// The files in and below a folder.
struct FilesBelow {
    std::vector<std::string> paths;     ///< sorted
    std::vector<std::string> warnings;  ///< sentences about what was left out
};

/// All files in a folder and in the folders below it, through at most `deepest` of them, and at most 50,000 files among
/// 200,000 entries. Links count for nothing: what lies inside is met anyway, and what lies outside is not asked for.
/// Warnings tell of links out of the folder or to nowhere, and of pipes, sockets and devices. They also tell of folders
/// that are too deep or cannot be read, and of more files or entries than that. If `progress` is cancelled, the files
/// found until then come back.
[[nodiscard]] FilesBelow walkFilesBelow(const std::string& folder, int deepest, const Progress& progress);

/// File names for a sentence, without folders: the first three in quotes, and how many more there are. `paths` holds at
/// least one.
[[nodiscard]] std::string filesInWords(const std::vector<std::string>& paths);

}  // namespace echolucent
