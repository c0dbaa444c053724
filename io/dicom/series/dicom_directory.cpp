#include "io/dicom/series/dicom_directory.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_names.h"
#include "io/headers/header_text.h"

namespace echolucent {

namespace {

constexpr std::size_t mostFiles = 50000;
constexpr int deepestName = 8;  // DICOM's file names have at most eight parts
constexpr DicomTag recordsTag{0x0004, 0x1220};
constexpr DicomTag inUseTag{0x0004, 0x1410};
constexpr DicomTag fileTag{0x0004, 0x1500};

/// A file's name below its folder, in small letters with one slash between the parts.
std::string nameBelow(const std::string& folder, const std::string& path) {
    return lowerCase(std::filesystem::path(path).lexically_relative(folder).generic_string());
}

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

}  // namespace

FilesBelow filesBelow(const std::string& folder, int deepest, const Progress& progress) {
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
    if (error) found.warnings.push_back(fmt::format("The folder was not read to its end: {}.", error.message()));
    std::sort(found.paths.begin(), found.paths.end());
    return found;
}

bool isDirectoryFile(const InputFile& file, const Progress& progress) {
    const auto beginning = file.beginning(4096);
    // The meta header stands there; most files are told apart without being walked.
    const bool named = beginning && beginning->find(directorySopClass) != std::string::npos;
    if (!named || !looksLikeDicom(*beginning)) return false;
    const auto scan = scanDicom(file, progress, true);
    return scan && scan->sopClass == directorySopClass;
}

Result<DirectoryFiles> filesOfDirectory(const InputFile& input, const Progress& progress) {
    const auto file = DicomFile::load(input, true, progress);
    if (!file) return tl::unexpected(file.error());
    std::string folder = std::filesystem::path(input.path()).parent_path().string();
    if (folder.empty()) folder = ".";
    std::map<std::string, std::string> there;
    FilesBelow below = filesBelow(folder, deepestName, progress);
    for (std::string& path : below.paths) {
        std::string name = nameBelow(folder, path);
        there.emplace(std::move(name), std::move(path));
    }
    DirectoryFiles found;
    found.warnings = std::move(below.warnings);
    std::set<std::string> taken;
    dicomVisitItems(file->dataset(), recordsTag, [&](DcmItem& record) {
        std::string name = dicomText(record, fileTag);
        if (name.empty() || dicomWholeNumber(record, inUseTag).value_or(0xffff) == 0) return true;
        std::replace(name.begin(), name.end(), '\\', '/');
        ++found.named;
        const auto path = there.find(lowerCase(name));
        if (path == there.end()) {
            if (found.firstMissing.empty()) found.firstMissing = name;
        } else if (taken.insert(path->second).second) {
            found.paths.push_back(path->second);
        }
        return !progress.cancelled();
    });
    if (progress.cancelled()) return fail(FailureKind::cancelled, input.path(), "", "was not read: cancelled");
    if (found.named == 0)
        return fail(FailureKind::unreadable, input.path(), "(0004,1220) Directory Record Sequence",
                    "of this DICOMDIR names no files", "Open the folder that holds the images.");
    return found;
}

}  // namespace echolucent
