#include "io/output/unfinished_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>

#include "io/output/interruption.h"
#include "io/output/output_place.h"

namespace echolucent {

namespace {

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Returns 0 or an errno.
int copyInto(int descriptor, const std::string& from) {
    const OpenFile source(std::fopen(from.c_str(), "rb"), &std::fclose);
    if (!source) return errno;
    std::array<char, 1 << 16> bytes{};
    for (std::size_t read = 0; (read = std::fread(bytes.data(), 1, bytes.size(), source.get())) > 0;)
        for (std::size_t done = 0; done < read;) {
            const ssize_t count = write(descriptor, bytes.data() + done, read - done);
            if (count < 0 && errno != EINTR) return errno;
            if (count > 0) done += static_cast<std::size_t>(count);
        }
    return std::ferror(source.get()) == 0 ? 0 : EIO;
}

/// Sets the permissions and flushes the bytes to the disk, so that a crash leaves no empty file after the rename.
/// Returns 0 or an errno.
int complete(const std::string& name, mode_t mode) {
    const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    const int problem = fchmod(descriptor, mode) == 0 && fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    return problem;
}

/// Returns 0 or an errno.
int renameTo(const std::string& target, const std::string& name) {
    UninterruptedStep step;
    if (std::rename(name.c_str(), target.c_str()) != 0) return errno;
    step.forgetUnfinished(name);
    return 0;
}

}  // namespace

Result<UnfinishedFile> UnfinishedFile::beside(const std::string& path, std::string_view ending, OutputKind kind) {
    const auto place = placeOfOutput(path, kind);
    if (!place) return tl::unexpected<Failure>(place.error());
    UnfinishedFile file;
    file.m_path = path;
    file.m_kind = kind;
    std::string name = pathBeside(place->target, ".XXXXXX" + std::string(ending));
    if (place->descriptor >= 0) {
        std::error_code error;
        auto folder = std::filesystem::temp_directory_path(error);
        if (error) folder = ".";
        name = (folder / "echolucent-XXXXXX").string() + std::string(ending);
    }
    UninterruptedStep step;
    const int descriptor = mkstemps(name.data(), static_cast<int>(ending.size()));
    if (descriptor < 0) return cannotWrite(path, errno);
    ::close(descriptor);
    step.noteUnfinished(name);
    file.m_name = name;
    return file;
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept
    : m_path(std::move(other.m_path)), m_kind(other.m_kind), m_name(std::exchange(other.m_name, {})) {}

UnfinishedFile& UnfinishedFile::operator=(UnfinishedFile&& other) noexcept {
    remove();
    m_path = std::move(other.m_path);
    m_kind = other.m_kind;
    m_name = std::exchange(other.m_name, {});
    return *this;
}

UnfinishedFile::~UnfinishedFile() { remove(); }

void UnfinishedFile::remove() {
    if (m_name.empty()) return;
    UninterruptedStep step;
    std::remove(m_name.c_str());
    step.forgetUnfinished(m_name);
    m_name.clear();
}

Result<void> UnfinishedFile::putInPlace() {
    const auto place = placeOfOutput(m_path, m_kind);
    if (!place) {
        remove();
        return tl::unexpected<Failure>(place.error());
    }
    int problem = 0;
    if (place->descriptor >= 0) {
        std::fflush(stdout);
        problem = copyInto(place->descriptor, m_name);
    } else if (problem = complete(m_name, place->mode); problem == 0) {
        problem = renameTo(place->target, m_name);
        if (problem == 0) m_name.clear();
    }
    remove();
    return problem == 0 ? Result<void>() : cannotWrite(m_path, problem);
}

}  // namespace echolucent
