#include "io/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

namespace echolucent {

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes) {
    if (path == "-") {
        if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
            return fail(FailureKind::unwritable, "standard output", "", "could not be written");
        return {};
    }
    std::string temporary = path + ".XXXXXX";
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0)
        return fail(FailureKind::unwritable, path, "", std::string("could not be written: ") + std::strerror(errno),
                    "Choose another folder or name.");
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(descriptor, "wb"), &std::fclose);
    bool written = file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                   std::fflush(file.get()) == 0 && fchmod(descriptor, 0644) == 0 && fsync(descriptor) == 0;
    int problem = errno;
    file.reset();
    if (written && std::rename(temporary.c_str(), path.c_str()) != 0) {
        written = false;
        problem = errno;
    }
    if (!written) {
        std::remove(temporary.c_str());
        return fail(FailureKind::unwritable, path, "", std::string("could not be written: ") + std::strerror(problem),
                    "Choose another folder or name.");
    }
    return {};
}

Result<std::string> readWholeFile(const std::string& path, std::size_t limit) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return fail(FailureKind::unreadable, path, "", "is not a file that can be read", "Check the name.");
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return fail(FailureKind::unreadable, path, "", std::string("could not be opened: ") + std::strerror(errno));
    const auto size = std::filesystem::file_size(path, error);
    if (error || size > limit)
        return fail(FailureKind::unreadable, path, "", "is larger than a file of this kind can be");
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::size_t>(stream.gcount()) != size)
        return fail(FailureKind::unreadable, path, "", "could not be read to its end");
    return bytes;
}

}  // namespace echolucent
