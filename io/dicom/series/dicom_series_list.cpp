#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include "io/dicom/elements/dicom_scan.h"
#include "io/dicom/series/concatenation.h"
#include "io/dicom/series/dicom_directory.h"
#include "io/dicom/series/image_header.h"
#include "io/dicom/series/large_stack.h"
#include "io/dicom/series/series_entries.h"
#include "io/dicom/series/slice_groups.h"
#include "io/files/file_access.h"
#include "io/files/files_below.h"
#include "io/files/header_text.h"
#include "io/files/input_file.h"
#include "io/files/input_problems.h"
#include "io/study/series_list.h"
#include "io/study/study_assembly.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

constexpr int deepestFolder = 4;

bool isFolder(const std::string& path) { return fileAccess().kindOf(path) == FileKind::folder; }

Result<std::vector<std::string>> filesOf(SeriesList& list, const Progress& progress) {
    if (isFolder(list.path)) {
        FilesBelow found = fileAccess().filesBelow(list.path, deepestFolder, progress);
        list.warnings = std::move(found.warnings);
        return std::move(found.paths);
    }
    const auto input = InputFile::open(list.path);
    if (!input) return tl::unexpected(input.error());
    Result<DirectoryFiles> found = fail(FailureKind::unreadable, list.path, "", "was not read");
    runWithLargeStack([&] { found = filesOfDirectory(*input, progress); });
    if (!found) return tl::unexpected(found.error());
    list.files.push_back(list.path);
    list.warnings = std::move(found->warnings);
    if (found->paths.empty()) {
        const std::string problem = fmt::format(
            "is a DICOMDIR, and none of the {} files that it names is in its folder or below it", found->named);
        if (found->others.empty())
            return fail(FailureKind::unreadable, list.path, "", problem,
                        "Copy the whole medium, the DICOMDIR and the folders beside it.");
        return fail(FailureKind::unreadable, list.path, "",
                    fmt::format("{}. {} other DICOM file(s) are: {}", problem, found->others.size(),
                                filesInWords(found->others)),
                    "Open the folder itself, or copy the whole medium again.");
    }
    if (found->renamed > 0)
        list.warnings.push_back(fmt::format(
            "{} of {} files that the DICOMDIR names have another ending here, {} among them; they were taken "
            "for those.",
            found->renamed, found->named, filesInWords({found->firstRenamed})));
    if (found->missing > 0)
        list.warnings.push_back(
            fmt::format("{} of {} files that the DICOMDIR names are not in its folder or below it, {} among them.",
                        found->missing, found->named, quotedText(found->firstMissing)));
    return found->paths;
}

/// A file's name in small letters, with "0" in place of each number. The names of a series' slices mostly differ only
/// in numbers.
std::string namePattern(const std::string& path) {
    std::string pattern;
    for (const char letter : lowerCase(nameFromPath(path)))
        if (letter < '0' || letter > '9')
            pattern += letter;
        else if (pattern.empty() || pattern.back() != '0')
            pattern += '0';
    return pattern;
}

bool hasDicomEnding(const std::string& path) {
    const std::string name = lowerCase(path);
    return std::ranges::any_of(dicomEndings, [&](std::string_view ending) { return name.ends_with(ending); });
}

/// What lookAt() found in all files of a folder.
struct Findings {
    std::vector<ImageHeader> images;
    std::vector<DamagedFile> damaged;
    std::vector<std::string> packed, empty, unopened;
    std::optional<Failure> whyUnopened;  // of the first in `unopened`
};

/// Adds to `found.damaged` the files that are no whole images but seem meant as slices. Either they share the series
/// UID and the SOP class of an image, or they are no DICOM but have a DICOM ending or a name like an image.
void findMeantSlices(const std::vector<std::string>& files, std::vector<LookedAt>& looked, Findings& found) {
    std::set<std::pair<std::string, std::string>> kinds;
    std::set<std::string> patterns;
    for (const ImageHeader& image : found.images) {
        if (!image.series.empty()) kinds.emplace(image.series, image.sopClass);
        patterns.insert(namePattern(image.file.path));
    }
    const auto damaged = [&](std::size_t i, const char* problem) {
        found.damaged.push_back(
            {files[i], fail(FailureKind::unreadable, files[i], "", problem, copyAgain).value(), {}});
    };
    for (std::size_t i = 0; i < files.size(); ++i) {
        const LookedAt& one = looked[i];
        if (one.kind == LookedAt::Kind::otherDicom && kinds.contains({one.series, one.sopClass}))
            damaged(i, "belongs to the images beside it and holds none: it was cut off");
        else if (one.kind == LookedAt::Kind::unknown &&
                 (hasDicomEnding(files[i]) || patterns.contains(namePattern(files[i]))))
            damaged(i, "is no DICOM, though its name says so");
    }
}

Findings sortOut(const std::vector<std::string>& files, std::vector<LookedAt>& looked) {
    Findings found;
    for (std::size_t i = 0; i < files.size(); ++i) {
        LookedAt& one = looked[i];
        switch (one.kind) {
            case LookedAt::Kind::image: found.images.push_back(std::move(*one.header)); break;
            case LookedAt::Kind::damaged:
                found.damaged.push_back({files[i], one.damage, {}});
                if (one.header) found.damaged.back().header = std::move(*one.header);
                break;
            case LookedAt::Kind::packed: found.packed.push_back(files[i]); break;
            case LookedAt::Kind::empty: found.empty.push_back(files[i]); break;
            case LookedAt::Kind::unopened:
                if (found.unopened.empty()) found.whyUnopened = one.damage;
                found.unopened.push_back(files[i]);
                break;
            default: break;
        }
    }
    findMeantSlices(files, looked, found);
    return found;
}

/// A failure without the file's name.
std::string reasonOf(const Failure& failure) {
    return failure.element.empty() ? failure.problem : failure.element + " " + failure.problem;
}

std::vector<std::string> pathsOf(const std::vector<DamagedFile>& files) {
    std::vector<std::string> paths;
    paths.reserve(files.size());
    for (const DamagedFile& file : files) paths.push_back(file.path);
    return paths;
}

/// Warns of files that are in no series.
void sayLeftOut(const Findings& found, const std::vector<DamagedFile>& damaged, std::vector<std::string>& warnings) {
    if (!damaged.empty())
        warnings.push_back(fmt::format("{} {}file(s) were left out: {}. The first {}.", damaged.size(),
                                       isDamage(damaged.front().damage) ? "damaged " : "",
                                       filesInWords(pathsOf(damaged)), reasonOf(damaged.front().damage)));
    if (!found.empty.empty())
        warnings.push_back(
            fmt::format("{} file(s) are empty (0 bytes): {}.", found.empty.size(), filesInWords(found.empty)));
    if (!found.unopened.empty())
        warnings.push_back(fmt::format("{} file(s) were left out: {}. The first {}.", found.unopened.size(),
                                       filesInWords(found.unopened), reasonOf(*found.whyUnopened)));
    if (!found.packed.empty())
        warnings.push_back(fmt::format(
            "{} file(s) are packed with gzip and were not looked into, {} among them. Unpack them if they are slices.",
            found.packed.size(), filesInWords({found.packed.front()})));
}

tl::unexpected<Failure> noSeries(const SeriesList& list, const std::vector<DamagedFile>& damaged) {
    if (damaged.size() == 1) return tl::unexpected(damaged.front().damage);
    if (!damaged.empty())
        return fail(
            FailureKind::unreadable, list.path, "",
            fmt::format("holds {} DICOM files, and {}: {}. The first {}", damaged.size(),
                        isDamage(damaged.front().damage) ? "all of them are damaged" : "none can be read",
                        filesInWords(pathsOf(damaged)), reasonOf(damaged.front().damage)),
            isDamage(damaged.front().damage) ? "Copy or export the series again." : damaged.front().damage.remedy);
    std::string problem = isFolder(list.path) ? "is a folder without DICOM images" : "names no DICOM images";
    if (!list.warnings.empty()) problem += " that could be read";
    for (const std::string& warning : list.warnings)
        problem += ". " + warning.substr(0, warning.find_last_not_of('.') + 1);
    return fail(FailureKind::unreadable, list.path, "", problem,
                "Choose a volume file, or the folder that holds a DICOM series.");
}

/// Names the unreadable files beside a series that is no volume, and what the walk left out, since its slices may be
/// among them.
void nameMissing(const Findings& found, const std::vector<DamagedFile>& damaged,
                 const std::vector<std::string>& leftOut, std::vector<SeriesEntry>& entries) {
    std::vector<std::string> lost = pathsOf(damaged);
    lost.insert(lost.end(), found.empty.begin(), found.empty.end());
    lost.insert(lost.end(), found.unopened.begin(), found.unopened.end());
    std::vector<std::string> reasons;
    if (!lost.empty())
        reasons.push_back(fmt::format("{} file(s) beside it could not be read: {}", lost.size(), filesInWords(lost)));
    for (const std::string& warning : leftOut) reasons.push_back(warning.substr(0, warning.find(". ")));
    if (reasons.empty()) return;
    std::string more = fmt::format("{}", fmt::join(reasons, "; "));
    if (more.back() == '.') more.pop_back();
    for (SeriesEntry& entry : entries)
        if (entry.whyNot && (!entry.multiframe || isAboutParts(*entry.whyNot)))
            entry.whyNot->problem += fmt::format(" ({})", more);
}

}  // namespace

bool holdsSeries(const std::string& path) {
    const FileKind kind = fileAccess().kindOf(path);
    if (kind == FileKind::folder) return true;
    const auto input =
        kind == FileKind::file ? InputFile::open(path) : fail(FailureKind::unreadable, path, "", "is no file");
    return input && isDirectoryFile(*input, {});
}

Result<SeriesList> listSeries(const std::string& path, const Progress& progress) {
    SeriesList list;
    list.path = path;
    const auto named = filesOf(list, progress);
    if (!named) return tl::unexpected(named.error());
    const std::vector<std::string>& files = *named;
    const std::vector<std::string> leftOut = list.warnings;
    std::vector<LookedAt> looked(files.size());
    const Progress third{[&](double share) { progress.at(0.3 * share); }, progress.cancel};
    const std::size_t threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    runEachWithLargeStack(
        files.size(), threads, [&](std::size_t index) { looked[index] = lookAt(files[index], progress); }, third);
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    for (std::size_t i = 0; i < files.size(); ++i)
        if (looked[i].kind != LookedAt::Kind::packed && looked[i].kind != LookedAt::Kind::unknown)
            list.files.push_back(files[i]);
    Findings found = sortOut(files, looked);
    SortedSeries sorted;
    runWithLargeStack(
        [&] { sorted = sortIntoSeries(path, std::move(found.images), std::move(found.damaged), progress); });
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    list.series = std::move(sorted.entries);
    list.warnings.insert(list.warnings.end(), sorted.warnings.begin(), sorted.warnings.end());
    sayLeftOut(found, sorted.leftOut, list.warnings);
    if (list.series.empty()) return noSeries(list, sorted.leftOut);
    nameMissing(found, sorted.leftOut, leftOut, list.series);
    return list;
}

Result<const SeriesEntry*> findSeries(const SeriesList& list, const std::string& uid) {
    if (uid.empty()) return &list.series.front();
    const auto found =
        std::find_if(list.series.begin(), list.series.end(), [&](const SeriesEntry& one) { return one.uid == uid; });
    if (found != list.series.end()) return &*found;
    std::vector<std::string> there;
    for (const SeriesEntry& entry : list.series)
        if (there.size() < 10)
            there.push_back(fmt::format("{} ({}{}{})", there.size() + 1,
                                        entry.description.empty() ? "" : quotedText(entry.description) + ", ",
                                        sizeInWords(entry), entry.distinction.empty() ? "" : ", " + entry.distinction));
    const std::string more = list.series.size() > there.size() ? ", ..." : "";
    return fail(FailureKind::unreadable, list.path, "", "holds no series " + quotedText(uid),
                fmt::format("It holds {}{}. Choose one of the numbers that info lists.", fmt::join(there, ", "), more));
}

std::string sizeInWords(const SeriesEntry& entry) {
    const std::string picture = fmt::format("{} x {}", entry.size[0], entry.size[1]);
    if (entry.size[2] == 1) return picture + (entry.multiframe ? ", one file" : ", one picture");
    const std::string slices = fmt::format("{}, {} {}", picture, entry.size[2], entry.multiframe ? "frames" : "slices");
    return entry.phases.count > 1 ? fmt::format("{}, {} phases", slices, entry.phases.count) : slices;
}

}  // namespace echolucent
