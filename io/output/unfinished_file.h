// A file that a library writes by its name, and that appears in its place whole or not at all.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "processing/result.h"

namespace echolucent {

/// An empty file beside its place, which is removed where putInPlace() is not reached. Moved from, it holds none.
class UnfinishedFile {
public:
    /// Makes it beside `path`, so that it can be renamed to it; where `path` is a device, a pipe or "-" (standard
    /// output), in the temporary folder. `ending` is what its own name ends with. Fails (unwritable) where `path` is a
    /// folder, or lies in one that is not there or cannot be written into.
    [[nodiscard]] static Result<UnfinishedFile> beside(const std::string& path, std::string_view ending = {});
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    ~UnfinishedFile();

    /// Where it is written.
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// Renames it to its path; nobody may be writing it any more. A file that is there keeps its permissions, a link
    /// stays a link; into a device or a pipe it is copied. Fails (unwritable) where that cannot be done; what was at
    /// the path is then as it was.
    [[nodiscard]] Result<void> putInPlace();

private:
    UnfinishedFile() = default;
    void remove();

    std::string m_path;    ///< as the person named it
    std::string m_name;    ///< empty where there is none any more
    std::string m_target;  ///< what it is renamed to; empty where it is copied instead
    mode_t m_mode = 0;     ///< its permissions in its place
};

}  // namespace echolucent
