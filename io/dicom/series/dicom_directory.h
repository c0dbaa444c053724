// DICOMDIR: a list of the files on a medium.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/input_file.h"

namespace echolucent {

/// The files of a DICOMDIR.
struct DirectoryFiles {
    std::vector<std::string> paths;     ///< that are there, in or below the DICOMDIR's own folder; each once
    std::size_t named = 0;              ///< how many different names the records hold
    std::size_t missing = 0;            ///< how many of these are not there
    std::string firstMissing;           ///< the first of them, as the record spells it
    std::vector<std::string> warnings;  ///< on folders that could not be looked through
};

/// Whether the first 4096 bytes of a file leave it possible that it is a DICOMDIR.
[[nodiscard]] bool mayBeDirectory(std::string_view beginning);
/// Whether an opened file is a DICOMDIR.
[[nodiscard]] bool isDirectoryFile(const InputFile& file, const Progress& progress);

/// The files that the records of a DICOMDIR name. Records are taken one after the other as they stand in the file:
/// their links are not followed, so that none can lead in a circle. A name counts where the DICOMDIR's own folder holds
/// such a file, whatever the case of its letters where none has the very name; names that lead out of it are missing.
/// Fails (unreadable) where the file holds no records; (cancelled) where the person ended it. To be called in a thread
/// with a large stack.
[[nodiscard]] Result<DirectoryFiles> filesOfDirectory(const InputFile& file, const Progress& progress);

}  // namespace echolucent
