#include "io/output/output_place.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

namespace echolucent {

namespace {

constexpr const char* elsewhere = "Choose another folder or name.";

/// The permissions of a new file, by the person's umask. The umask belongs to the whole process and can only be read by
/// setting it, so it is read before other threads begin.
const mode_t modeOfNewFiles = [] {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}();

tl::unexpected<Failure> isNoPlace(const std::string& path, const std::string& why) {
    return fail(FailureKind::unwritable, path, "", "could not be written: " + why, elsewhere);
}

/// The descriptor that a path names; no value if it names none.
std::optional<int> descriptorNamed(std::string_view path) {
    if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder)) continue;
        int number = -1;
        const auto [end, problem] = std::from_chars(path.data() + folder.size(), path.data() + path.size(), number);
        if (problem == std::errc() && end == path.data() + path.size() && number >= 0) return number;
    }
    return std::nullopt;
}

const char* kindOfFile(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a named pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

/// Fails if no file can be made in the folder of `path`.
Result<void> checkFolder(const std::string& path, const std::string& folder) {
    struct stat there {};
    if (stat(folder.c_str(), &there) != 0) {
        if (errno == EACCES) return isNoPlace(path, "there is no permission to look into its folder");
        if (errno == ENOENT || errno == ENOTDIR) return isNoPlace(path, "its folder is not there");
        return cannotWrite(path, errno);
    }
    if (!S_ISDIR(there.st_mode)) return isNoPlace(path, "its folder is not there");
    if (access(folder.c_str(), W_OK | X_OK) == 0) return {};
    if (errno == EROFS) return isNoPlace(path, "its folder is on a disk that can only be read");
    return isNoPlace(path, "there is no permission to write into its folder");
}

}  // namespace

std::string OutputPlace::folder() const {
    std::string parent = std::filesystem::path(target).parent_path().string();
    return parent.empty() ? "." : parent;
}

Result<OutputPlace> placeOfOutput(const std::string& path, OutputKind kind) {
    OutputPlace place;
    if (const auto descriptor = descriptorNamed(path)) {
        const int flags = fcntl(*descriptor, F_GETFL);
        if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) return isNoPlace(path, "it is not open for writing");
        place.descriptor = *descriptor;
        return place;
    }
    struct stat present {};
    const bool exists = stat(path.c_str(), &present) == 0;
    if (exists && !S_ISREG(present.st_mode))
        return isNoPlace(path, std::string("it is ") + kindOfFile(present.st_mode));
    if (auto allowed = refuseToOverwriteKept(path, kind); !allowed) return tl::unexpected<Failure>(allowed.error());
    // The file that a link points to is replaced, so that the link stays.
    std::error_code error;
    const auto resolved = std::filesystem::canonical(path, error);
    place.target = error ? path : resolved.string();
    place.mode = exists ? present.st_mode & 07777 : modeOfNewFiles;
    if (auto writable = checkFolder(path, place.folder()); !writable) return tl::unexpected<Failure>(writable.error());
    return place;
}

std::string pathBeside(const std::string& path, const std::string& suffix) {
    const auto slash = path.rfind('/');
    const std::size_t name = path.size() - (slash == std::string::npos ? 0 : slash + 1);
    const std::size_t longest = NAME_MAX - std::min<std::size_t>(suffix.size(), NAME_MAX);
    return path.substr(0, path.size() - (name > longest ? name - longest : 0)) + suffix;
}

tl::unexpected<Failure> cannotWrite(const std::string& path, int problem) {
    return fail(FailureKind::unwritable, path == "-" ? "standard output" : path, "",
                std::string("could not be written: ") + std::strerror(problem),
                problem == ENOSPC || problem == EDQUOT ? "Make room, or choose another folder." : elsewhere);
}

}  // namespace echolucent
