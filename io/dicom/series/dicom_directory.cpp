#include "io/dicom/series/dicom_directory.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/elements/dicom_names.h"
#include "io/files/file_access.h"
#include "io/files/header_text.h"

namespace echolucent {

namespace {

constexpr int deepestName = 8;  // DICOM's file names have at most eight parts
constexpr DicomTag recordsTag{0x0004, 0x1220};
constexpr DicomTag inUseTag{0x0004, 0x1410};
constexpr DicomTag fileTag{0x0004, 0x1500};

/// The path of a file relative to `folder`, with one slash between the parts.
std::string nameBelow(const std::string& folder, const std::string& path) {
    return std::filesystem::path(path).lexically_relative(folder).generic_string();
}

/// The files below a folder by their names, as spelled and in small letters.
class NamedFiles {
public:
    void add(std::string name, const std::string& path) {
        m_small.emplace(lowerCase(name), path);
        m_exact.emplace(std::move(name), path);
    }
    /// Null if no file has that name.
    [[nodiscard]] const std::string* find(const std::string& name) const {
        if (const auto exact = m_exact.find(name); exact != m_exact.end()) return &exact->second;
        const auto small = m_small.find(lowerCase(name));
        return small != m_small.end() ? &small->second : nullptr;
    }

private:
    std::map<std::string, std::string> m_exact, m_small;
};

}  // namespace

bool mayBeDirectory(std::string_view beginning) {
    // The meta header, which names the SOP class, is in these bytes. So most files need no walk.
    return beginning.find(directorySopClass) != std::string_view::npos && looksLikeDicom(beginning);
}

bool isDirectoryFile(const InputFile& file, const Progress& progress) {
    const auto beginning = file.beginning(4096);
    if (!beginning || !mayBeDirectory(*beginning)) return false;
    const auto scan = scanDicom(file, progress, true);
    return scan && scan->sopClass == directorySopClass;
}

Result<DirectoryFiles> filesOfDirectory(const InputFile& input, const Progress& progress) {
    const auto file = DicomFile::load(input, true, progress);
    if (!file) return tl::unexpected(file.error());
    std::string folder = std::filesystem::path(input.path()).parent_path().string();
    if (folder.empty()) folder = ".";
    FilesBelow below = fileAccess().filesBelow(folder, deepestName, progress);
    NamedFiles there;
    for (const std::string& path : below.paths) there.add(nameBelow(folder, path), path);
    DirectoryFiles found;
    found.warnings = std::move(below.warnings);
    std::set<std::string> names, taken;
    dicomVisitItems(file->dataset(), recordsTag, [&](DcmItem& record) {
        std::string name = dicomText(record, fileTag);
        if (name.empty() || dicomWholeNumber(record, inUseTag).value_or(0xffff) == 0) return true;
        std::replace(name.begin(), name.end(), '\\', '/');
        if (!names.insert(name).second) return true;
        const std::string* path = there.find(name);
        if (path == nullptr && found.missing++ == 0) found.firstMissing = name;
        if (path != nullptr && taken.insert(*path).second) found.paths.push_back(*path);
        return !progress.cancelled();
    });
    found.named = names.size();
    if (progress.cancelled()) return fail(FailureKind::cancelled, input.path(), "", "was not read: cancelled");
    if (found.named == 0)
        return fail(FailureKind::unreadable, input.path(), "(0004,1220) Directory Record Sequence",
                    "of this DICOMDIR names no files", "Open the folder that holds the images.");
    return found;
}

}  // namespace echolucent
