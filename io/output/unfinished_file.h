// A file that a library writes by its name. It appears in its place whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// A file beside its place, empty at first. It is removed unless putInPlace() succeeds, even if a signal ends the
/// program (removeUnfinishedOnSignals()). A moved-from object holds none.
class UnfinishedFile {
public:
    /// Makes the file beside `path`, so that it can be renamed to `path`. If `path` names a descriptor ("-",
    /// /dev/stdout and the like), the file lies in the temporary folder. `ending` is the end of the file's own name.
    /// Fails as placeOfOutput() does for a file of this kind, and (unwritable) if the file cannot be made.
    [[nodiscard]] static Result<UnfinishedFile> beside(const std::string& path, std::string_view ending = {},
                                                       OutputKind kind = OutputKind::other);
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    ~UnfinishedFile();

    /// The path to write to; empty after putInPlace().
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// Renames the file to its path, or copies it into the descriptor. Nobody may write to the file any more. An
    /// existing file keeps its permissions, and a link stays a link. Fails as placeOfOutput(), which is called again,
    /// and (unwritable) if renaming or copying fails. The file is then removed, and what was at the path stays.
    [[nodiscard]] Result<void> putInPlace();

private:
    UnfinishedFile() = default;
    void remove();

    std::string m_path;  ///< as the person gave it
    OutputKind m_kind = OutputKind::other;
    std::string m_name;  ///< empty if there is none any more
};

}  // namespace echolucent
