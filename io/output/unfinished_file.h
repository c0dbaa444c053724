// A file that a library writes by its name, and that appears in its place whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// An empty file beside its place, which is removed where putInPlace() is not reached, be it that a signal ends the
/// program (removeUnfinishedOnSignals()). Moved from, it holds none.
class UnfinishedFile {
public:
    /// Makes it beside `path`, so that it can be renamed to it; where `path` names a descriptor ("-", /dev/stdout and
    /// its like), in the temporary folder. `ending` is what its own name ends with. Fails as placeOfOutput() does for a
    /// file of this kind.
    [[nodiscard]] static Result<UnfinishedFile> beside(const std::string& path, std::string_view ending = {},
                                                       OutputKind kind = OutputKind::other);
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    ~UnfinishedFile();

    /// Where it is written.
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// Renames it to its path; nobody may be writing it any more. A file that is there keeps its permissions, a link
    /// stays a link; into a descriptor it is copied. Fails as placeOfOutput() does, which is asked again, and
    /// (unwritable) where that cannot be done; what was at the path is then as it was.
    [[nodiscard]] Result<void> putInPlace();

private:
    UnfinishedFile() = default;
    void remove();

    std::string m_path;  ///< as the person named it
    OutputKind m_kind = OutputKind::other;
    std::string m_name;  ///< empty where there is none any more
};

}  // namespace echolucent
