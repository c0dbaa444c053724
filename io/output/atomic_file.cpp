#include "io/output/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

namespace echolucent {

namespace {

tl::unexpected<Failure> cannotWrite(const std::string& path, int problem) {
    return fail(FailureKind::unwritable, path, "", std::string("could not be written: ") + std::strerror(problem),
                "Choose another folder or name.");
}

/// Writes `bytes` and closes the descriptor. Gives 0, or the errno of what went wrong.
int writeAndClose(int descriptor, std::string_view bytes, bool regular) {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(descriptor, "wb"), &std::fclose);
    errno = 0;
    const bool written = file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                         std::fflush(file.get()) == 0 && (!regular || fsync(descriptor) == 0);
    return written ? 0 : (errno != 0 ? errno : EIO);
}

/// The permissions of a new file, as the person's umask has them.
mode_t modeOfNewFiles() {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/// Writes the bytes into a device or a pipe, which cannot be replaced.
Result<void> writeInto(const std::string& path, std::string_view bytes) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return cannotWrite(path, errno);
    if (const int problem = writeAndClose(descriptor, bytes, false)) return cannotWrite(path, problem);
    return {};
}

}  // namespace

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes) {
    if (path == "-") {
        if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
            return fail(FailureKind::unwritable, "standard output", "", "could not be written");
        return {};
    }
    struct stat present {};
    const bool exists = stat(path.c_str(), &present) == 0;
    if (exists && S_ISDIR(present.st_mode)) return cannotWrite(path, EISDIR);
    if (exists && !S_ISREG(present.st_mode)) return writeInto(path, bytes);
    // The file that a link points to is replaced, so that a link stays a link.
    std::error_code unresolved;
    const auto resolved = std::filesystem::canonical(path, unresolved);
    const std::string target = unresolved ? path : resolved.string();

    std::string temporary = target + ".XXXXXX";
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0) return cannotWrite(path, errno);
    const mode_t mode = exists ? present.st_mode & 07777 : modeOfNewFiles();
    int problem = fchmod(descriptor, mode) == 0 ? 0 : errno;
    const int afterWriting = writeAndClose(descriptor, bytes, true);
    if (problem == 0) problem = afterWriting;
    if (problem == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) problem = errno;
    if (problem == 0) return {};
    std::remove(temporary.c_str());
    return cannotWrite(path, problem);
}

}  // namespace echolucent
