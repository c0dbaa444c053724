#include "io/files/file_access.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>

#include "io/files/input_problems.h"

namespace echolucent {

namespace {

/// The file system itself.
class DirectFileAccess : public FileAccess {
public:
    Result<int> open(const std::string& path) override {
        // O_NONBLOCK keeps a named pipe without a writer from blocking the program. Regular files ignore it.
        const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (number >= 0) return number;
        return fail(FailureKind::unreadable, path, "", "could not be opened: " + inputProblem(errno),
                    "Check the name and the permissions.");
    }

    FileKind kindOf(const std::string& path) override {
        struct stat status {};
        if (stat(path.c_str(), &status) != 0)
            return errno == EACCES        ? FileKind::forbidden
                   : isDiscFailure(errno) ? FileKind::unreachable
                                          : FileKind::missing;
        if (S_ISREG(status.st_mode)) return FileKind::file;
        return S_ISDIR(status.st_mode) ? FileKind::folder : FileKind::other;
    }

    std::string resolved(const std::string& path) override {
        std::error_code error;
        // Otherwise a relative path with missing parts would stay relative.
        const auto whole = std::filesystem::absolute(path.empty() ? "." : path, error);
        if (error) return path;
        const auto end = std::filesystem::weakly_canonical(whole, error);
        return error ? path : end.string();
    }

    FilesBelow filesBelow(const std::string& folder, int deepest, const Progress& progress) override {
        return walkFilesBelow(folder, deepest, progress);
    }
};

FileAccess*& accessInUse() {
    static DirectFileAccess direct;
    static FileAccess* access = &direct;
    return access;
}

}  // namespace

FileAccess& fileAccess() { return *accessInUse(); }

void useFileAccess(FileAccess& access) { accessInUse() = &access; }

}  // namespace echolucent
