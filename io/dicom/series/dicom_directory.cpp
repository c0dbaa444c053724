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
#include "io/file_access.h"
#include "io/headers/header_text.h"

namespace echolucent {

namespace {

constexpr int deepestName = 8;  // DICOM's file names have at most eight parts
constexpr DicomTag recordsTag{0x0004, 0x1220};
constexpr DicomTag inUseTag{0x0004, 0x1410};
constexpr DicomTag fileTag{0x0004, 0x1500};

/// A file's name below its folder, in small letters with one slash between the parts.
std::string nameBelow(const std::string& folder, const std::string& path) {
    return lowerCase(std::filesystem::path(path).lexically_relative(folder).generic_string());
}

}  // namespace

bool mayBeDirectory(std::string_view beginning) {
    // The meta header stands there; most files are told apart without being walked.
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
    std::map<std::string, std::string> there;
    FilesBelow below = fileAccess().filesBelow(folder, deepestName, progress);
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
