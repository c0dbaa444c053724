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
#include "processing/ascii_letters.h"

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

/// A name in small letters, without what a file system may add: a version (";1") and a dot at the end.
std::string plainName(const std::string& name) {
    std::string plain = lowerCase(name);
    const auto version = plain.find_last_of(';');
    if (version != std::string::npos && version + 1 < plain.size() &&
        plain.find_first_not_of("0123456789", version + 1) == std::string::npos)
        plain.resize(version);
    if (plain.size() > 1 && plain.back() == '.') plain.pop_back();
    return plain;
}

/// A plain name without its ending; the name itself if it has none.
std::string withoutEnding(const std::string& name) {
    const auto slash = name.find_last_of('/');
    const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
    const auto dot = name.find_last_of('.');
    return dot == std::string::npos || dot <= begin ? name : name.substr(0, dot);
}

bool beginsAsDicom(const std::string& path) {
    const auto input = InputFile::open(path);
    const auto beginning = input ? input->beginning(132) : Result<std::string>(tl::unexpected(input.error()));
    return beginning && looksLikeDicom(*beginning);
}

bool endsAsDicom(const std::string& name) {
    return std::ranges::any_of(dicomEndings, [&](std::string_view ending) { return name.ends_with(ending); });
}

/// Whether the ending of a plain name is one that programs add: of letters. ".840" is a part of a name.
bool hasEndingOfLetters(const std::string& name) {
    const std::string_view ending = std::string_view(name).substr(withoutEnding(name).size());
    return ending.size() > 1 &&
           std::ranges::all_of(ending.substr(1), [](char letter) { return letter >= 'a' && letter <= 'z'; });
}

/// The files below a folder by their names: as spelled, in small letters, and without endings.
class NamedFiles {
public:
    void add(std::string name, const std::string& path) {
        const std::string plain = plainName(name);
        if (hasEndingOfLetters(plain)) m_bare[withoutEnding(plain)].push_back(path);
        m_small.emplace(plain, path);
        m_exact.emplace(std::move(name), path);
    }
    /// Null if no file has that name.
    [[nodiscard]] const std::string* find(const std::string& name) const {
        if (const auto exact = m_exact.find(name); exact != m_exact.end()) return &exact->second;
        const auto small = m_small.find(plainName(name));
        return small != m_small.end() ? &small->second : nullptr;
    }
    /// A file whose name has an ending more, or lacks DICOM's ending, or has another one of DICOM's. Null if there is
    /// none that begins as DICOM does or has an ending that says so.
    [[nodiscard]] const std::string* findWithOtherEnding(const std::string& name) const {
        const std::string plain = plainName(name);
        if (const std::string* longer = findBare(plain, true)) return longer;
        if (!endsAsDicom(plain)) return nullptr;
        const std::string bare = withoutEnding(plain);
        const auto shorter = m_small.find(bare);
        return shorter != m_small.end() && beginsAsDicom(shorter->second) ? &shorter->second : findBare(bare, false);
    }

private:
    [[nodiscard]] const std::string* findBare(const std::string& bare, bool anyEnding) const {
        const auto there = m_bare.find(bare);
        if (there == m_bare.end()) return nullptr;
        for (const std::string& path : there->second)
            if (endsAsDicom(lowerCase(path))) return &path;
        if (anyEnding)
            for (const std::string& path : there->second)
                if (beginsAsDicom(path)) return &path;
        return nullptr;
    }

    std::map<std::string, std::string> m_exact, m_small;
    std::map<std::string, std::vector<std::string>> m_bare;
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
        if (path == nullptr) {
            path = there.findWithOtherEnding(name);
            if (path != nullptr && found.renamed++ == 0) found.firstRenamed = *path;
        }
        if (path == nullptr && found.missing++ == 0) found.firstMissing = name;
        if (path != nullptr && taken.insert(*path).second) found.paths.push_back(*path);
        return !progress.cancelled();
    });
    found.named = names.size();
    if (progress.cancelled()) return fail(FailureKind::cancelled, input.path(), "", "was not read: cancelled");
    if (found.named == 0)
        return fail(FailureKind::unreadable, input.path(), "(0004,1220) Directory Record Sequence",
                    "of this DICOMDIR names no files", "Open the folder that holds the images.");
    if (!found.paths.empty()) return found;
    constexpr std::size_t mostLookedAt = 1000;
    for (std::size_t i = 0; i < std::min(mostLookedAt, below.paths.size()) && !progress.cancelled(); ++i)
        if (below.paths[i] != input.path() && beginsAsDicom(below.paths[i])) found.others.push_back(below.paths[i]);
    return found;
}

}  // namespace echolucent
