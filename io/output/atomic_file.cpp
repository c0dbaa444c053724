#include "io/output/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "io/files/descriptor.h"
#include "io/output/interruption.h"
#include "io/output/output_place.h"
#include "io/output/unfinished_file.h"

namespace echolucent {

namespace {

/// Whether a nameless file is possible here and, if so, 0 or the errno of writing it.
struct Nameless {
    bool possible = false;
    int problem = 0;
};

/// Gives a nameless file its place. Only a file with a name can replace an existing one, so it gets another name for a
/// moment. Returns 0 or an errno.
int putInPlace(const std::string& nameless, const OutputPlace& place) {
    const auto linkTo = [&](const std::string& name) {
        return linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
    };
    UninterruptedStep step;
    if (const int problem = linkTo(place.target); problem != EEXIST) return problem;
    constexpr int mostTries = 1000;
    for (int attempt = 0; attempt < mostTries; ++attempt) {
        const std::string name =
            pathBeside(place.target, '.' + std::to_string(getpid()) + '-' + std::to_string(attempt));
        const int problem = linkTo(name);
        if (problem == EEXIST) continue;
        if (problem != 0) return problem;
        if (std::rename(name.c_str(), place.target.c_str()) == 0) return 0;
        const int renaming = errno;
        unlink(name.c_str());
        return renaming;
    }
    return EEXIST;
}

/// A file without a name leaves nothing behind if the program ends while it is written. Some file systems have no such
/// files.
Nameless writeNameless(const OutputPlace& place, std::string_view bytes) {
    const Descriptor file(open(place.folder().c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600));
    if (file.number() < 0) return {};
    const std::string itself = "/proc/self/fd/" + std::to_string(file.number());
    if (access(itself.c_str(), F_OK) != 0) return {};
    if (const int problem = writeAll(file.number(), bytes)) return {true, problem};
    // fsync() before the naming: a crash of the machine leaves no empty file under the new name.
    if (fchmod(file.number(), place.mode) != 0 || fsync(file.number()) != 0) return {true, errno};
    return {true, putInPlace(itself, place)};
}

Result<void> writeNamed(const std::string& path, std::string_view bytes, OutputKind kind) {
    auto file = UnfinishedFile::beside(path, {}, kind);
    if (!file) return tl::unexpected<Failure>(file.error());
    const Descriptor named(open(file->name().c_str(), O_WRONLY | O_CLOEXEC));
    const int problem = named.number() < 0 ? errno : writeAll(named.number(), bytes);
    return problem == 0 ? file->putInPlace() : cannotWrite(path, problem);
}

}  // namespace

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes, OutputKind kind) {
    const auto place = placeOfOutput(path, kind);
    if (!place) return tl::unexpected<Failure>(place.error());
    if (place->descriptor >= 0) {
        std::fflush(stdout);
        const int problem = writeAll(place->descriptor, bytes);
        return problem == 0 ? Result<void>() : cannotWrite(path, problem);
    }
    const Nameless written = writeNameless(*place, bytes);
    if (!written.possible) return writeNamed(path, bytes, kind);
    return written.problem == 0 ? Result<void>() : cannotWrite(path, written.problem);
}

}  // namespace echolucent
