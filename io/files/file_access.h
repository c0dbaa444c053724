// The file system as the readers see it. Strangers' bytes are parsed in a process that can open nothing, so readers ask
// for files and folders here only.
#pragma once

#include <string>

#include "io/files/files_below.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What a path leads to.
enum class FileKind {
    missing,
    forbidden,    ///< something may be there, but permissions hide it
    unreachable,  ///< its disc, or the connection to it, failed
    file,         ///< a regular file
    folder,
    other,  ///< a device, a named pipe, a socket
};

/// Answers readers' questions about the file system. Several threads may ask at once.
class FileAccess {
public:
    FileAccess() = default;
    virtual ~FileAccess() = default;
    FileAccess(const FileAccess&) = delete;
    FileAccess& operator=(const FileAccess&) = delete;

    /// Opens the file at `path` for reading; the caller closes the descriptor. Fails (unreadable) if it cannot be
    /// opened.
    [[nodiscard]] virtual Result<int> open(const std::string& path) = 0;
    /// The kind of what the path leads to. Links are followed.
    [[nodiscard]] virtual FileKind kindOf(const std::string& path) = 0;
    /// The absolute path without links, "." and "..", as far as it exists; `path` as it is if the system does not tell.
    [[nodiscard]] virtual std::string resolved(const std::string& path) = 0;
    /// As walkFilesBelow().
    [[nodiscard]] virtual FilesBelow filesBelow(const std::string& folder, int deepest, const Progress& progress) = 0;
};

/// The access that this process uses: the file system itself, unless another was set.
[[nodiscard]] FileAccess& fileAccess();
/// Sets another access for the rest of the process. Call it before the first reader runs; `access` must outlive all
/// readers.
void useFileAccess(FileAccess& access);

}  // namespace echolucent
