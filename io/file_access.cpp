#include "io/file_access.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include <fmt/format.h>

#include "io/headers/header_text.h"
#include "io/input_problems.h"

namespace echolucent {

namespace {

constexpr std::size_t mostFiles = 50000;

/// Counts folders for one sentence.
class FoldersLeftOut {
public:
    void add(const std::filesystem::path& folder) {
        if (m_count++ == 0) m_first = folder.filename().string();
    }
    void say(const std::string& what, std::vector<std::string>& warnings) const {
        if (m_count > 0)
            warnings.push_back(fmt::format("{} folder(s) {}, {} among them.", m_count, what, quotedText(m_first)));
    }

private:
    std::size_t m_count = 0;
    std::string m_first;
};

/// The file system itself.
class DirectFileAccess : public FileAccess {
public:
    Result<int> open(const std::string& path) override {
        // O_NONBLOCK keeps a named pipe without a writer from holding the program; regular files ignore it.
        const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (number >= 0) return number;
        return fail(FailureKind::unreadable, path, "", "could not be opened: " + inputProblem(errno),
                    "Check the name and the permissions.");
    }

    FileKind kindOf(const std::string& path) override {
        struct stat status {};
        if (stat(path.c_str(), &status) != 0) return errno == EACCES ? FileKind::forbidden : FileKind::missing;
        if (S_ISREG(status.st_mode)) return FileKind::file;
        return S_ISDIR(status.st_mode) ? FileKind::folder : FileKind::other;
    }

    std::string resolved(const std::string& path) override {
        std::error_code error;
        // What is missing on a relative path would stay relative otherwise.
        const auto whole = std::filesystem::absolute(path.empty() ? "." : path, error);
        if (error) return path;
        const auto end = std::filesystem::weakly_canonical(whole, error);
        return error ? path : end.string();
    }

    FilesBelow filesBelow(const std::string& folder, int deepest, const Progress& progress) override {
        FilesBelow found;
        FoldersLeftOut deeper, closed;
        std::error_code error;
        std::filesystem::recursive_directory_iterator entry(
            folder, std::filesystem::directory_options::skip_permission_denied, error);
        for (; !error && !progress.cancelled() && entry != std::filesystem::recursive_directory_iterator();
             entry.increment(error)) {
            std::error_code unknown;
            if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) {
                const std::filesystem::directory_iterator inside(entry->path(), unknown);
                if (unknown) closed.add(entry->path());
                if (entry.depth() < deepest) continue;
                entry.disable_recursion_pending();
                if (!unknown && inside != std::filesystem::directory_iterator()) deeper.add(entry->path());
            } else if (entry->is_regular_file(unknown)) {
                if (found.paths.size() == mostFiles) {
                    found.warnings.push_back(fmt::format(
                        "There are more than {} files; the others were not looked at. Open a folder further down.",
                        mostFiles));
                    break;
                }
                found.paths.push_back(entry->path().string());
            }
        }
        deeper.say(fmt::format("deeper than {} were not looked into", deepest), found.warnings);
        closed.say("could not be opened", found.warnings);
        if (error)
            found.warnings.push_back(
                fmt::format("The folder was not read to its end: {}.", inputProblem(error.value())));
        std::sort(found.paths.begin(), found.paths.end());
        return found;
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
