#include "io/document/session_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "io/files/input_file.h"
#include "io/output/overwriting.h"

namespace echolucent {

namespace {

namespace fs = std::filesystem;

/// The absolute path, with links resolved as far as it exists.
fs::path whole(const fs::path& path) {
    std::error_code error;
    fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? fs::absolute(path, error).lexically_normal() : found;
}

bool isFolder(const std::string& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

/// Whether one path is another, or lies below it.
bool liesIn(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

bool looksLikeDocument(const std::string& path) {
    constexpr std::size_t looked = 4096;
    // A pipe would block the caller.
    struct stat status {};
    if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    const auto input = InputFile::open(path);
    if (!input) return false;
    const auto beginning = input->beginning(looked);
    if (!beginning) return false;
    const auto text = beginning->find_first_not_of(" \t\r\n");
    return text != std::string::npos && (*beginning)[text] == '{' &&
           beginning->find(documentFormatName) != std::string::npos;
}

SavedSession asNamedFrom(const std::string& file, SavedSession session) {
    auto* study = std::get_if<StudyFile>(&session.document.study);
    if (study == nullptr) return session;
    const fs::path folder = whole(file).parent_path();
    const fs::path path = whole(study->path);
    const fs::path above = folder.parent_path();
    if (liesIn(path, folder) || (above != folder.root_path() && liesIn(path, above)))
        study->path = path.lexically_relative(folder).string();
    else
        study->path = path.string();
    for (Snapshot& snapshot : session.snapshots) snapshot.document.study = session.document.study;
    return session;
}

std::string studyPathFrom(const std::string& file, const std::string& path) {
    const fs::path beside = (fs::path(file).parent_path() / path).lexically_normal();
    std::error_code error;
    const bool fromWorkingFolder = !fs::exists(beside, error) && fs::exists(path, error);
    return fromWorkingFolder ? path : beside.string();
}

std::optional<std::string> placeOfStudy(const StudyFile& study, const std::string& file, StudySearch search,
                                        const Progress& progress) {
    std::string stated = studyPathFrom(file, study.path);
    std::error_code error;
    if (fs::exists(stated, error)) return stated;
    const std::string folder = fs::path(file).parent_path().string();
    search.folders.insert(search.folders.begin(), folder.empty() ? "." : folder);
    return findStudy(study, search, progress);
}

namespace {

constexpr std::string_view sessionEnding = ".session.json";

/// The path without a slash at its end.
fs::path plainPath(const std::string& study) {
    const fs::path path = fs::path(study).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

}  // namespace

std::string stemOfStudy(const std::string& study) {
    const fs::path path = plainPath(study);
    if (isFolder(study)) return path.filename().string();
    // "heart.nii.gz" is packed "heart.nii".
    const bool twoEndings = path.extension() == ".gz" || path.filename().string().ends_with(sessionEnding);
    return twoEndings ? path.stem().stem().string() : path.stem().string();
}

Result<void> refuseSessionInside(const std::string& study, const std::vector<std::string>& files,
                                 const std::string& file) {
    if (!study.empty() && isFolder(study) && liesIn(whole(file), whole(study)))
        return fail(FailureKind::wrongUsage, file, "", "would lie in the folder that is the study",
                    "Save the session beside that folder.");
    return refuseToOverwrite(files, {file});
}

}  // namespace echolucent
