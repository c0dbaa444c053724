// DICOMDIR: the list of the files on a medium.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/input_file.h"

namespace echolucent {

/// The files of a DICOMDIR.
struct DirectoryFiles {
    std::vector<std::string> paths;     ///< existing files in or below the DICOMDIR's own folder, each once
    std::size_t named = 0;              ///< how many different names the records in use hold
    std::size_t missing = 0;            ///< how many of these names have no such file
    std::string firstMissing;           ///< the first of the missing names, with slashes between its parts
    std::size_t renamed = 0;            ///< how many names belong to a file with another ending, one more or one less
    std::string firstRenamed;           ///< the path of the first of these
    std::vector<std::string> others;    ///< if `paths` is empty: DICOM files that are there and are not named
    std::vector<std::string> warnings;  ///< on folders that could not be read
};

/// Whether a file with these first 4096 bytes may be a DICOMDIR.
[[nodiscard]] bool mayBeDirectory(std::string_view beginning);
/// Whether an opened file is a DICOMDIR.
[[nodiscard]] bool isDirectoryFile(const InputFile& file, const Progress& progress);

/// The files that the records of a DICOMDIR name. The records are read in the order of the file. Their links are not
/// followed, so none can lead in a circle. A name counts as found if the DICOMDIR's own folder holds such a file. If no
/// file has exactly this name, upper and lower case are not told apart, and a version of the file system (";1") counts
/// for nothing. Else a DICOM file with another ending counts, one more or one less. A name that leads out of the folder
/// counts as missing.
/// Fails (unreadable) if the file cannot be parsed or if no record in use names a file; (cancelled) if the person ended
/// it. Call it in a thread with a large stack.
[[nodiscard]] Result<DirectoryFiles> filesOfDirectory(const InputFile& file, const Progress& progress);

}  // namespace echolucent
