// A file that a library writes by its name. It appears in its place whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// An empty file beside its place. It is removed unless putInPlace() is reached, even if a signal ends the program
/// (removeUnfinishedOnSignals()). A moved-from object holds none.
class UnfinishedFile {
public:
    /// Makes the file beside `path`, so that it can be renamed to it. If `path` names a descriptor ("-", /dev/stdout
    /// and the like), it lies in the temporary folder. `ending` is the end of its own name. Fails as placeOfOutput()
    /// does for a file of this kind.
    [[nodiscard]] static Result<UnfinishedFile> beside(const std::string& path, std::string_view ending = {},
                                                       OutputKind kind = OutputKind::other);
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    ~UnfinishedFile();

    /// The path to write to.
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// Renames the file to its path, or copies it into the descriptor. Nobody may still write it. An existing file
    /// keeps its permissions, and a link stays a link. Fails as placeOfOutput(), which is asked again, and (unwritable)
    /// if that cannot be done; the path is then as it was.
    [[nodiscard]] Result<void> putInPlace();

private:
    UnfinishedFile() = default;
    void remove();

    std::string m_path;  ///< as the person gave it
    OutputKind m_kind = OutputKind::other;
    std::string m_name;  ///< empty if there is none any more
};

}  // namespace echolucent
