#include "io/output/unfinished_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

namespace echolucent {

namespace {

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

tl::unexpected<Failure> cannotWrite(const std::string& path, int problem) {
    return fail(FailureKind::unwritable, path == "-" ? "standard output" : path, "",
                std::string("could not be written: ") + std::strerror(problem), "Choose another folder or name.");
}

/// The permissions of a new file, as the person's umask has them. The umask belongs to the whole process and can only
/// be read by setting it, so that it is read before there are threads.
const mode_t modeOfNewFiles = [] {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}();

/// Gives 0, or the errno of what went wrong.
int copyInto(std::FILE* target, const std::string& from) {
    const OpenFile source(std::fopen(from.c_str(), "rb"), &std::fclose);
    if (!source) return errno;
    std::array<char, 1 << 16> bytes{};
    for (std::size_t read = 0; (read = std::fread(bytes.data(), 1, bytes.size(), source.get())) > 0;)
        if (std::fwrite(bytes.data(), 1, read, target) != read) return errno != 0 ? errno : EIO;
    if (std::ferror(source.get()) != 0) return EIO;
    return std::fflush(target) == 0 ? 0 : errno;
}

int copyTo(const std::string& path, const std::string& from) {
    if (path == "-") return copyInto(stdout, from);
    const OpenFile target(std::fopen(path.c_str(), "wb"), &std::fclose);
    return target ? copyInto(target.get(), from) : errno;
}

/// Gives the file its permissions and brings what was written to the disk, so that a crash leaves no empty file behind
/// the rename. Gives 0, or an errno.
int complete(const std::string& name, mode_t mode) {
    const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    const int problem = fchmod(descriptor, mode) == 0 && fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    return problem;
}

}  // namespace

Result<UnfinishedFile> UnfinishedFile::beside(const std::string& path, std::string_view ending) {
    UnfinishedFile file;
    file.m_path = path;
    struct stat present {};
    const bool exists = path != "-" && stat(path.c_str(), &present) == 0;
    if (exists && S_ISDIR(present.st_mode)) return cannotWrite(path, EISDIR);
    std::error_code error;
    std::string name;
    if (path == "-" || (exists && !S_ISREG(present.st_mode))) {
        auto folder = std::filesystem::temp_directory_path(error);
        if (error) folder = ".";
        name = (folder / "echolucent-XXXXXX").string();
    } else {
        // The file that a link points to is replaced, so that a link stays a link.
        const auto resolved = std::filesystem::canonical(path, error);
        file.m_target = error ? path : resolved.string();
        name = file.m_target + ".XXXXXX";
    }
    name += ending;
    const int descriptor = mkstemps(name.data(), static_cast<int>(ending.size()));
    if (descriptor < 0) return cannotWrite(path, errno);
    ::close(descriptor);
    file.m_name = name;
    file.m_mode = exists ? present.st_mode & 07777 : modeOfNewFiles;
    return file;
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept
    : m_path(std::move(other.m_path)),
      m_name(std::exchange(other.m_name, {})),
      m_target(std::move(other.m_target)),
      m_mode(other.m_mode) {}

UnfinishedFile& UnfinishedFile::operator=(UnfinishedFile&& other) noexcept {
    remove();
    m_path = std::move(other.m_path);
    m_name = std::exchange(other.m_name, {});
    m_target = std::move(other.m_target);
    m_mode = other.m_mode;
    return *this;
}

UnfinishedFile::~UnfinishedFile() { remove(); }

void UnfinishedFile::remove() {
    if (!m_name.empty()) std::remove(m_name.c_str());
    m_name.clear();
}

Result<void> UnfinishedFile::putInPlace() {
    if (m_target.empty()) {
        const int problem = copyTo(m_path, m_name);
        remove();
        return problem == 0 ? Result<void>() : cannotWrite(m_path, problem);
    }
    int problem = complete(m_name, m_mode);
    if (problem == 0 && std::rename(m_name.c_str(), m_target.c_str()) != 0) problem = errno;
    if (problem != 0) {
        remove();
        return cannotWrite(m_path, problem);
    }
    m_name.clear();
    return {};
}

}  // namespace echolucent
