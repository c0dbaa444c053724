#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_geometry.h"
#include "io/dicom/dicom_grey.h"
#include "io/dicom/dicom_study.h"
#include "io/dicom/frame_layout.h"
#include "io/dicom/philips_volume.h"
#include "io/dicom/pixels/dicom_rescale.h"
#include "io/dicom/series/dicom_directory.h"
#include "io/dicom/series/large_stack.h"
#include "io/dicom/series/series_description.h"
#include "io/file_access.h"
#include "io/gzip_file.h"
#include "io/headers/header_text.h"
#include "io/input_file.h"
#include "io/series_list.h"

namespace echolucent {

namespace {

constexpr int deepestFolder = 4;

/// What the header of one image says.
struct ImageHeader {
    SeriesFile file;
    std::string series, object;  // UIDs of series and image
    std::string description, modality;
    std::int64_t rows = 0, columns = 0, frames = 1;
    bool volume = false;            // whether the file alone is one, whatever its frames
    std::optional<Failure> whyNot;  // of a multi-frame file
};

/// What is wrong with the pixels of many frames, as far as header and length tell it: no more frames are looked at than
/// the file can hold.
std::optional<Failure> wrongPixels(const DicomFile& file, std::uint64_t fileBytes) {
    const auto failure = [&](const PixelFormatProblem& problem) {
        return fail(FailureKind::unreadable, file.path(), problem.element, problem.text, "Export it again.").value();
    };
    DicomPixelFormat format;
    if (const auto problem = readPixelFormat(file.dataset(), format)) return failure(*problem);
    const DicomScan& scan = file.scan();
    if (!DcmXfer(scan.transferSyntax.c_str()).isEncapsulated()) {
        const auto problem = wrongPixelBytes(format, scan.pixelBytesHeld);
        return problem ? std::optional(failure(*problem)) : std::nullopt;
    }
    constexpr std::uint64_t itemBytes = 8;  // a frame has one fragment at least
    if (static_cast<std::uint64_t>(format.frames) <= fileBytes / itemBytes) return std::nullopt;
    return failure({"(0028,0008) Number of Frames",
                    fmt::format("says {}, more than a file of {} bytes can hold", format.frames, fileBytes)});
}

/// Why the frames of one file are no volume, as far as the header says it.
std::optional<Failure> whyNoVolume(DcmItem& dataset, const ImageHeader& header, const Progress& progress) {
    const auto count = static_cast<std::size_t>(header.frames);
    const auto layout = layOutFrames(dataset, header.file.path, {count, header.columns, header.rows}, progress);
    return layout ? std::nullopt : std::optional(layout.error());
}

/// Finds out whether the file is a volume of its own, and why not. The size of a maker's private volume counts in place
/// of its frames.
void takeVolume(const DicomFile& file, std::uint64_t fileBytes, ImageHeader& header, const Progress& progress) {
    header.volume = file.scan().holdsKretz;
    if (header.volume) return;
    const auto philips = philipsVolumeOf(file);
    header.volume = philips && *philips;
    const bool inFrames = !header.volume || (*philips)->kind == PhilipsVolume::Kind::frames;
    if (inFrames && header.frames > 1) header.whyNot = wrongPixels(file, fileBytes);
    if (header.whyNot) return;
    if (!philips)
        header.whyNot = philips.error();
    else if (!header.volume && header.frames > 1)
        header.whyNot = whyNoVolume(file.dataset(), header, progress);
    if (!header.volume) return;
    header.columns = (*philips)->size[0];
    header.rows = (*philips)->size[1];
    header.frames = (*philips)->size[2];
}

/// Whether Rescale Slope and Intercept change the values of a single picture.
bool isRescaled(DcmItem& dataset) {
    DicomPixelFormat format;
    if (readPixelFormat(dataset, format)) return false;
    const auto rescales = readRescales(dataset, format);
    return rescales && !rescales->of(0).isIdentity();
}

/// The header of an image; no value for DICOM files that are no images.
Result<std::optional<ImageHeader>> headerOf(const InputFile& input, const Progress& progress) {
    auto file = DicomFile::load(input, true, progress);
    if (!file) return tl::unexpected(file.error());
    const bool kretz = file->scan().holdsKretz;
    if (!file->scan().hasPixelData && !kretz) return std::optional<ImageHeader>();
    DcmItem& dataset = file->dataset();
    const auto rows = dicomWholeNumber(dataset, {0x0028, 0x0010});
    const auto columns = dicomWholeNumber(dataset, {0x0028, 0x0011});
    if ((!rows || !columns) && !kretz) return std::optional<ImageHeader>();
    ImageHeader header;
    header.file.path = input.path();
    header.file.instance = dicomWholeNumber(dataset, {0x0020, 0x0013}).value_or(0);
    if (const auto placement = topLevelPlacement(dataset))
        header.file.plane =
            SlicePlane{*placement->position, (*placement->orientation)[0], (*placement->orientation)[1], input.path()};
    header.rows = rows.value_or(0);
    header.columns = columns.value_or(0);
    header.frames = std::max<std::int64_t>(1, dicomWholeNumber(dataset, {0x0028, 0x0008}).value_or(1));
    header.file.rescaled = header.frames == 1 && isRescaled(dataset);
    header.series = dicomText(dataset, {0x0020, 0x000e});
    header.object = dicomText(dataset, {0x0008, 0x0018});
    header.description = seriesDescription(dataset);
    header.modality = dicomText(dataset, {0x0008, 0x0060});
    takeVolume(*file, input.size(), header, progress);
    return std::optional(std::move(header));
}

/// What one file turned out to be.
struct Looked {
    bool dicom = false;
    bool packed = false;
    std::optional<ImageHeader> header;
    std::optional<Failure> failure;
};

Looked lookAt(const std::string& path, const Progress& progress) {
    Looked looked;
    if (progress.cancelled()) return looked;
    const auto input = InputFile::open(path);
    if (!input) return looked;
    const auto beginning = input->beginning(132);
    looked.packed = beginning && looksLikeGzip(*beginning);
    if (!beginning || !looksLikeDicom(*beginning)) return looked;
    looked.dicom = true;
    auto header = headerOf(*input, progress);
    if (header)
        looked.header = std::move(*header);
    else
        looked.failure = header.error();
    return looked;
}

/// Puts the slices of an entry in order, and says why they are no volume.
void orderSlices(const std::string& folder, SeriesEntry& entry) {
    auto& files = entry.files;
    std::stable_sort(files.begin(), files.end(),
                     [](const SeriesFile& a, const SeriesFile& b) { return a.instance < b.instance; });
    if (files.size() < 2) {
        entry.whyNot = fail(FailureKind::unreadable, files.front().path, "", "is a single 2D picture, not a volume",
                            "Open the folder that holds all slices, or a multi-frame file.")
                           .value();
        return;
    }
    std::vector<SlicePlane> planes;
    for (const SeriesFile& file : files)
        if (file.plane) planes.push_back(*file.plane);
    if (planes.size() < files.size()) {
        entry.whyNot =
            framesWithoutGeometry(
                folder, fmt::format("holds {} 2D pictures without position and orientation, no volume", files.size()))
                .value();
        return;
    }
    const auto stack = stackSlices(folder, imagePositionName, planes);
    if (!stack) {
        entry.whyNot = stack.error();
        return;
    }
    std::vector<SeriesFile> ordered;
    for (const std::size_t index : stack->order) ordered.push_back(std::move(files[index]));
    files = std::move(ordered);
}

/// Files that belong together: slices of one series and size; a multi-frame file stands alone.
std::vector<SeriesEntry> entriesFrom(const std::string& folder, std::vector<Looked>& looked) {
    using Key = std::tuple<std::string, std::int64_t, std::int64_t, std::string>;
    std::map<Key, std::vector<ImageHeader>> groups;
    for (Looked& one : looked)
        if (one.header) {
            ImageHeader& header = *one.header;
            Key key{header.series, header.rows, header.columns,
                    header.volume || header.frames > 1 ? header.file.path : ""};
            groups[std::move(key)].push_back(std::move(header));
        }
    std::vector<SeriesEntry> entries;
    for (auto& [key, headers] : groups) {
        ImageHeader& first = headers.front();
        SeriesEntry entry;
        entry.uid = first.series;
        entry.multiframe = first.volume || first.frames > 1;
        entry.description = first.description;
        entry.modality = first.modality;
        entry.size = {first.columns, first.rows,
                      entry.multiframe ? first.frames : static_cast<std::int64_t>(headers.size())};
        entry.whyNot = first.whyNot;
        entry.object = first.object;
        for (ImageHeader& header : headers) entry.files.push_back(std::move(header.file));
        if (!entry.multiframe) orderSlices(folder, entry);
        entries.push_back(std::move(entry));
    }
    std::stable_sort(entries.begin(), entries.end(), [](const SeriesEntry& a, const SeriesEntry& b) {
        return std::pair(a.whyNot.has_value(), -a.size[2]) < std::pair(b.whyNot.has_value(), -b.size[2]);
    });
    return entries;
}

/// Gives entries that share a Series Instance UID names of their own.
void nameApart(std::vector<SeriesEntry>& entries) {
    std::set<std::string> taken;
    for (SeriesEntry& entry : entries) {
        if (entry.uid.empty()) entry.uid = "unnamed";
        if (taken.insert(entry.uid).second) continue;
        if (entry.multiframe && !entry.object.empty())
            entry.uid = entry.object;
        else
            entry.uid += fmt::format(":{}x{}", entry.size[0], entry.size[1]);
        if (taken.insert(entry.uid).second) continue;
        const std::string name = entry.uid;
        for (int again = 2; !taken.insert(entry.uid).second; ++again) entry.uid = fmt::format("{}:{}", name, again);
    }
}

bool isFolder(const std::string& path) { return fileAccess().kindOf(path) == FileKind::folder; }

/// The files that a folder or a DICOMDIR holds.
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
    const std::size_t missing = found->named - std::min(found->named, found->paths.size());
    const std::string words =
        fmt::format("{} of {} files that the DICOMDIR names are not in its folder or below it, {} among them", missing,
                    found->named, quotedText(found->firstMissing));
    if (found->paths.empty())
        return fail(FailureKind::unreadable, list.path, "",
                    fmt::format("is a DICOMDIR, and none of the {} files that it names is in its folder or below it",
                                found->named),
                    "Copy the whole medium, the DICOMDIR and the folders beside it.");
    if (!found->firstMissing.empty()) list.warnings.push_back(words + ".");
    return found->paths;
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
    std::vector<Looked> looked(files.size());
    const Progress third{[&](double share) { progress.at(0.3 * share); }, progress.cancel};
    const std::size_t threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    runEachWithLargeStack(
        files.size(), threads, [&](std::size_t index) { looked[index] = lookAt(files[index], progress); }, third);
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    std::vector<Failure> failures;
    std::vector<std::string> packed;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (looked[i].dicom) list.files.push_back(files[i]);
        if (looked[i].packed) packed.push_back(nameFromPath(files[i]));
        if (looked[i].failure) failures.push_back(*looked[i].failure);
    }
    if (!packed.empty())
        list.warnings.push_back(fmt::format(
            "{} file(s) are packed with gzip and were not looked into, {} among them. Unpack them if they are slices.",
            packed.size(), quotedText(packed.front())));
    list.series = entriesFrom(path, looked);
    nameApart(list.series);
    if (list.series.empty() && !failures.empty()) return tl::unexpected(failures.front());
    if (list.series.empty())
        return fail(FailureKind::unreadable, path, "",
                    isFolder(path) ? "is a folder without DICOM images" : "names no DICOM images",
                    "Choose a volume file, or the folder that holds a DICOM series.");
    if (!failures.empty())
        list.warnings.push_back(fmt::format("{} DICOM file(s) could not be read and were left out. The first: {}",
                                            failures.size(), failures.front().sentence()));
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
            there.push_back(fmt::format("{} ({}{})", there.size() + 1,
                                        entry.description.empty() ? "" : quotedText(entry.description) + ", ",
                                        sizeInWords(entry)));
    const std::string more = list.series.size() > there.size() ? ", ..." : "";
    return fail(FailureKind::unreadable, list.path, "", "holds no series " + quotedText(uid),
                fmt::format("It holds {}{}. Choose one of the numbers that info lists.", fmt::join(there, ", "), more));
}

std::string sizeInWords(const SeriesEntry& entry) {
    const std::string picture = fmt::format("{} x {}", entry.size[0], entry.size[1]);
    if (entry.size[2] == 1) return picture + (entry.multiframe ? ", one file" : ", one picture");
    return fmt::format("{}, {} {}", picture, entry.size[2], entry.multiframe ? "frames" : "slices");
}

}  // namespace echolucent
