// Where an output goes, and where none may go.
#pragma once

#include <sys/types.h>

#include <string>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// A file to write or replace, or a descriptor that this process was started with.
struct OutputPlace {
    std::string target;   ///< the file, with links followed; empty if bytes go to `descriptor`
    mode_t mode = 0;      ///< permissions of the finished file: those of the existing file, else by the umask
    int descriptor = -1;  ///< for "-" and /dev/stdout, /dev/stderr, /dev/fd/N, /proc/self/fd/N; never close it

    /// The target's folder; "." if the target is only a name.
    [[nodiscard]] std::string folder() const;
};

/// Call it before the first byte of any output. Fails (unwritable, with the reason) if `path` is, or links to, a
/// folder, a device, a named pipe or a socket; if its folder is missing, or may not be entered or written; or if `path`
/// names a descriptor that is not open for writing. Fails (wrong usage) if a file of this kind would take the place of
/// a kept one (KeptFiles). It never blocks.
[[nodiscard]] Result<OutputPlace> placeOfOutput(const std::string& path, OutputKind kind = OutputKind::other);

/// A path for a file that lies beside `path` for a moment: `path` with `suffix` behind it. If that name would be longer
/// than file systems allow, the end of the path's own name is left out.
[[nodiscard]] std::string pathBeside(const std::string& path, const std::string& suffix);

/// "x.png: could not be written: No space left on device. …" for an errno.
[[nodiscard]] tl::unexpected<Failure> cannotWrite(const std::string& path, int problem);

}  // namespace echolucent
