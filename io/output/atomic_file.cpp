#include "io/output/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "io/output/unfinished_file.h"

namespace echolucent {

namespace {

tl::unexpected<Failure> cannotWrite(const std::string& path, int problem) {
    return fail(FailureKind::unwritable, path, "", std::string("could not be written: ") + std::strerror(problem),
                "Choose another folder or name.");
}

/// Writes the bytes into a file that is there, a device or a pipe. Gives 0, or the errno of what went wrong.
int writeInto(const std::string& path, std::string_view bytes) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(descriptor, "wb"), &std::fclose);
    errno = 0;
    const bool written =
        file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() && std::fflush(file.get()) == 0;
    return written ? 0 : (errno != 0 ? errno : EIO);
}

}  // namespace

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes) {
    if (path == "-") {
        if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
            return fail(FailureKind::unwritable, "standard output", "", "could not be written");
        return {};
    }
    struct stat present {};
    if (stat(path.c_str(), &present) == 0 && !S_ISREG(present.st_mode) && !S_ISDIR(present.st_mode)) {
        // A device or a pipe cannot be replaced.
        const int problem = writeInto(path, bytes);
        return problem == 0 ? Result<void>() : cannotWrite(path, problem);
    }
    auto file = UnfinishedFile::beside(path);
    if (!file) return tl::unexpected<Failure>(file.error());
    if (const int problem = writeInto(file->name(), bytes)) return cannotWrite(path, problem);
    return file->putInPlace();
}

}  // namespace echolucent
