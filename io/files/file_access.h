// The file system as the readers see it. What parses strangers' bytes runs where nothing can be opened, so that readers
// ask here, and only here, for files and folders.
#pragma once

#include <string>

#include "io/files/files_below.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What a path leads to.
enum class FileKind {
    missing,
    forbidden,  ///< something may be there, but a folder above it or the permissions do not let us look
    file,       ///< a regular file
    folder,
    other,  ///< a device, a named pipe, a socket
};

/// Answers what readers ask of the file system. May be asked from several threads at once.
class FileAccess {
public:
    FileAccess() = default;
    virtual ~FileAccess() = default;
    FileAccess(const FileAccess&) = delete;
    FileAccess& operator=(const FileAccess&) = delete;

    /// Opens the file at `path` for reading; the caller owns the descriptor. Fails (unreadable) where it cannot be
    /// opened.
    [[nodiscard]] virtual Result<int> open(const std::string& path) = 0;
    /// What the path leads to, over links.
    [[nodiscard]] virtual FileKind kindOf(const std::string& path) = 0;
    /// The path without links, "." and "..", as far as it exists; the path itself where that cannot be told.
    [[nodiscard]] virtual std::string resolved(const std::string& path) = 0;
    /// As walkFilesBelow().
    [[nodiscard]] virtual FilesBelow filesBelow(const std::string& folder, int deepest, const Progress& progress) = 0;
};

/// The one that this process uses: the file system itself, unless another was set.
[[nodiscard]] FileAccess& fileAccess();
/// Sets another for the rest of the process, before the first reader runs; it must outlive all readers.
void useFileAccess(FileAccess& access);

}  // namespace echolucent
