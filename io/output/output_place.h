// Where an output goes, and what may not be written.
#pragma once

#include <sys/types.h>

#include <string>

#include "io/output/overwriting.h"
#include "processing/result.h"

namespace echolucent {

/// A file that is made or replaced, or a descriptor that this process was started with.
struct OutputPlace {
    std::string target;   ///< the file, with the links to it followed; empty where bytes go to `descriptor`
    mode_t mode = 0;      ///< permissions that the finished file gets: its own where it is there, else the umask's
    int descriptor = -1;  ///< for "-" and /dev/stdout, /dev/stderr, /dev/fd/N, /proc/self/fd/N; never to be closed

    /// Of the target, "." where its name alone was given.
    [[nodiscard]] std::string folder() const;
};

/// Every output asks it before the first byte is written. Fails (unwritable, with what is there) where `path` is a
/// folder, a device, a named pipe or a socket, or a link to one, where its folder is not there or may not be looked
/// into or written into, or where a descriptor is not open for writing; and (wrong usage) where a file of this kind
/// would take the place of a kept one (KeptFiles). It never waits for anybody.
[[nodiscard]] Result<OutputPlace> placeOfOutput(const std::string& path, OutputKind kind = OutputKind::other);

/// "x.png: could not be written: No space left on device. …" for an errno.
[[nodiscard]] tl::unexpected<Failure> cannotWrite(const std::string& path, int problem);

}  // namespace echolucent
