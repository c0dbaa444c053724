#include <algorithm>
#include <filesystem>
#include <map>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_geometry.h"
#include "io/dicom/dicom_pixels.h"
#include "io/dicom/dicom_reader.h"
#include "io/dicom/dicom_study.h"
#include "io/input_file.h"

namespace echolucent {

namespace {

constexpr int deepestFolder = 4;
constexpr std::size_t mostFiles = 50000;
constexpr const char* positionName = "(0020,0032) Image Position";

/// What the header of one file in the folder says.
struct FileHeader {
    std::string path;
    std::string series;  // series and size: files that differ in it do not belong together
    std::int64_t frames = 1;
    std::int64_t instance = 0;
    std::optional<FramePlacement> placement;
};

/// Files of one series; a multi-frame file is a series of its own.
struct Series {
    std::vector<FileHeader> files;
    [[nodiscard]] std::int64_t slices() const {
        return files.front().frames > 1 ? files.front().frames : static_cast<std::int64_t>(files.size());
    }
};

std::vector<std::string> filesBelow(const std::string& folder, const Progress& progress) {
    std::vector<std::string> files;
    std::error_code error;
    std::filesystem::recursive_directory_iterator entry(
        folder, std::filesystem::directory_options::skip_permission_denied, error);
    for (; !error && !progress.cancelled() && entry != std::filesystem::recursive_directory_iterator();
         entry.increment(error)) {
        if (entry.depth() >= deepestFolder) entry.disable_recursion_pending();
        if (files.size() < mostFiles && entry->is_regular_file(error)) files.push_back(entry->path().string());
        error.clear();
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool isDicomFile(const std::string& path) {
    const auto file = InputFile::open(path);
    if (!file) return false;
    const auto beginning = file->beginning(4096);
    return beginning && looksLikeDicom(*beginning);
}

/// The header of an image; no value for DICOM files that are no images.
Result<std::optional<FileHeader>> headerOf(const std::string& path, const Progress& progress) {
    auto file = DicomFile::load(path, true, progress);
    if (!file) return tl::unexpected(file.error());
    if (!file->scan().hasPixelData) return std::optional<FileHeader>();
    DcmItem& dataset = file->dataset();
    const auto rows = dicomWholeNumber(dataset, {0x0028, 0x0010});
    const auto columns = dicomWholeNumber(dataset, {0x0028, 0x0011});
    if (!rows || !columns) return std::optional<FileHeader>();
    FileHeader header;
    header.path = path;
    header.frames = std::max<std::int64_t>(1, dicomWholeNumber(dataset, {0x0028, 0x0008}).value_or(1));
    header.instance = dicomWholeNumber(dataset, {0x0020, 0x0013}).value_or(0);
    header.placement = topLevelPlacement(dataset);
    header.series = fmt::format("{} {} {} {}", dicomText(dataset, {0x0020, 0x000e}), *rows, *columns,
                                header.frames > 1 ? path : "");
    return std::optional(std::move(header));
}

/// The images of a folder, most slices first, and what could not be read.
struct FolderContents {
    std::vector<std::string> files;  ///< all DICOM files, those of other series and unreadable ones among them
    std::vector<Series> series;
    std::size_t unreadable = 0;
    std::optional<Failure> firstFailure;
};

Result<FolderContents> contentsOf(const std::string& folder, const Progress& progress) {
    FolderContents contents;
    std::map<std::string, Series> series;
    const auto files = filesBelow(folder, progress);
    if (progress.cancelled()) return fail(FailureKind::cancelled, folder, "", "was not read: cancelled");
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, folder, "", "was not read: cancelled");
        progress.at(0.3 * static_cast<double>(i) / static_cast<double>(files.size()));
        if (!isDicomFile(files[i])) continue;
        contents.files.push_back(files[i]);
        auto header = headerOf(files[i], progress);
        if (header && *header) {
            series[(*header)->series].files.push_back(std::move(**header));
        } else if (!header && nameFromPath(files[i]) != "DICOMDIR") {
            ++contents.unreadable;
            if (!contents.firstFailure) contents.firstFailure = header.error();
        }
    }
    if (progress.cancelled()) return fail(FailureKind::cancelled, folder, "", "was not read: cancelled");
    for (auto& [key, one] : series) contents.series.push_back(std::move(one));
    std::stable_sort(contents.series.begin(), contents.series.end(),
                     [](const Series& a, const Series& b) { return a.slices() > b.slices(); });
    return contents;
}

/// Slices in order, with the geometry they share.
struct SliceOrder {
    std::vector<std::string> paths;
    VolumeGeometry geometry;
    std::string spacingSource;
    std::vector<std::string> warnings;
};

Result<SliceOrder> orderByPosition(const std::string& folder, const Series& series) {
    std::vector<SlicePlane> planes;
    for (const FileHeader& file : series.files)
        planes.push_back({*file.placement->position, (*file.placement->orientation)[0],
                          (*file.placement->orientation)[1], file.path});
    auto stack = stackSlices(folder, positionName, planes);
    if (!stack) return tl::unexpected(stack.error());
    SliceOrder order;
    for (const std::size_t index : stack->order) order.paths.push_back(series.files[index].path);
    order.geometry.origin = stack->origin;
    order.geometry.direction = stack->direction;
    order.geometry.patientFrameKnown = series.files.front().placement->orientationInPatient;
    order.geometry.spacing[2] = stack->spacing;
    order.warnings = stack->warnings;
    return order;
}

Result<SliceOrder> orderSlices(const std::string& folder, const Series& series, const ReadOptions& options) {
    const bool placed = std::all_of(series.files.begin(), series.files.end(),
                                    [](const FileHeader& file) { return file.placement.has_value(); });
    if (placed) return orderByPosition(folder, series);
    if (!options.framesAsSlices)
        return framesWithoutGeometry(
            folder,
            fmt::format("holds {} 2D pictures without position and orientation, no volume", series.files.size()));
    SliceOrder order;
    auto files = series.files;
    std::stable_sort(files.begin(), files.end(),
                     [](const FileHeader& a, const FileHeader& b) { return a.instance < b.instance; });
    for (const FileHeader& file : files) order.paths.push_back(file.path);
    order.geometry.spacingKnown = false;
    order.warnings.push_back("Pictures without position are taken as slices, in the order of their instance numbers.");
    return order;
}

/// Reads the slices in order into one block of voxels.
class SliceReader {
public:
    SliceReader(std::string folder, SliceOrder order, const ReadOptions& options, const Progress& progress)
        : m_order(std::move(order)), m_options(options), m_progress(progress) {
        m_parts.path = std::move(folder);
    }

    Result<Study> read() {
        for (std::size_t slice = 0; slice < m_order.paths.size(); ++slice) {
            if (m_progress.cancelled())
                return fail(FailureKind::cancelled, m_parts.path, "", "was not read: cancelled");
            m_progress.at(0.3 + 0.6 * static_cast<double>(slice) / static_cast<double>(m_order.paths.size()));
            if (const auto done = readSlice(slice); !done) return tl::unexpected(done.error());
        }
        m_parts.geometry = m_order.geometry;
        m_parts.spacingSource = m_order.spacingSource;
        m_parts.warnings.insert(m_parts.warnings.end(), m_order.warnings.begin(), m_order.warnings.end());
        shareWindow();
        std::vector<std::vector<std::uint8_t>> phases;
        phases.push_back(std::move(m_voxels));
        m_parts.voxels = convertVoxels(std::move(phases), m_type);
        return assembleStudy(std::move(m_parts), m_options, m_progress);
    }

private:
    Result<void> readSlice(std::size_t slice) {
        const auto file = DicomFile::load(m_order.paths[slice], false, m_progress);
        if (!file) return tl::unexpected(file.error());
        auto frames = DicomFrames::open(file->dataset(), file->path(), file->scan());
        if (!frames) return tl::unexpected(frames.error());
        const auto bytes = static_cast<std::size_t>(frames->frameBytes());
        std::vector<std::uint8_t> grey(bytes);
        if (const auto read = frames->readGrey(0, grey); !read) return read;
        if (slice == 0)
            if (const auto begun = begin(file->dataset(), *frames); !begun) return begun;
        if (frames->type() != m_type || bytes != m_sliceBytes || frames->largestValue() != m_largestValue)
            return fail(FailureKind::unreadable, file->path(), "(0028,0101) Bits Stored",
                        "makes this slice's pixels another type than the first slice's", "Export the series again.");
        std::copy(grey.begin(), grey.end(), m_voxels.begin() + static_cast<std::ptrdiff_t>(slice * bytes));
        m_parts.lossyCompressed = m_parts.lossyCompressed || frames->lossyCompressed();
        keepWindow(*frames);
        return {};
    }

    Result<void> begin(DcmItem& dataset, const DicomFrames& frames) {
        m_type = frames.type();
        m_sliceBytes = static_cast<std::size_t>(frames.frameBytes());
        const auto slices = static_cast<std::int64_t>(m_order.paths.size());
        const auto total = checkedProduct(frames.frameBytes(), slices);
        const auto memory =
            requireMemory(m_parts.path, "", total ? static_cast<std::uint64_t>(*total) : ~std::uint64_t{0});
        if (!memory) return memory;
        m_voxels.resize(static_cast<std::size_t>(*total));
        m_order.geometry.size = {frames.columns(), frames.rows(), slices};
        m_largestValue = frames.largestValue();
        frames.sayWhite(m_parts);
        m_parts.facts = {{"format", fmt::format("DICOM, {} slices", slices), ""}};
        for (auto&& fact : frames.facts()) m_parts.facts.push_back(std::move(fact));
        for (auto&& fact : equipmentFacts(dataset)) m_parts.facts.push_back(std::move(fact));
        for (auto&& warning : frames.warnings()) m_parts.warnings.push_back(std::move(warning));
        takeSpacing(dataset);
        return {};
    }

    void keepWindow(const DicomFrames& frames) {
        StudyParts said;
        frames.sayWhite(said);
        if (said.window) m_windows.push_back(std::move(*said.window));
    }

    /// The slices share one white level: where their windows differ, the median of their whites.
    void shareWindow() {
        if (m_windows.empty()) return;
        std::sort(m_windows.begin(), m_windows.end(),
                  [](const WindowWhite& a, const WindowWhite& b) { return a.white < b.white; });
        if (m_windows.front().white < m_windows.back().white)
            m_parts.warnings.push_back(fmt::format(
                "The slices declare windows with white from {:.6g} to {:.6g}; the one in their middle is asked.",
                m_windows.front().white, m_windows.back().white));
        m_parts.window = m_windows[m_windows.size() / 2];
    }

    void takeSpacing(DcmItem& dataset) {
        if (!m_order.geometry.spacingKnown) return;
        std::string source;
        if (const auto spacing = pixelSpacingOf(dataset, source)) {
            m_order.geometry.spacing[0] = (*spacing)[0];
            m_order.geometry.spacing[1] = (*spacing)[1];
            m_order.spacingSource = source + ", slice positions " + positionName;
        } else {
            m_order.geometry.spacing = {1, 1, 1};
            m_order.geometry.spacingKnown = false;
        }
    }

    SliceOrder m_order;
    const ReadOptions& m_options;
    const Progress& m_progress;
    StudyParts m_parts;
    StoredType m_type = StoredType::uint8;
    std::size_t m_sliceBytes = 0;
    double m_largestValue = 0.0;
    std::vector<WindowWhite> m_windows;  // of the slices that declare one
    std::vector<std::uint8_t> m_voxels;
};

}  // namespace

Result<Study> readSeriesFolder(const std::string& path, const ReadOptions& options, const Progress& progress) {
    const auto contents = contentsOf(path, progress);
    if (!contents) return tl::unexpected(contents.error());
    if (contents->series.empty()) {
        if (contents->firstFailure) return tl::unexpected(*contents->firstFailure);
        return fail(FailureKind::unreadable, path, "", "is a folder without DICOM images",
                    "Choose a volume file, or the folder that holds a DICOM series.");
    }
    const Series& largest = contents->series.front();
    std::vector<std::string> warnings;
    if (contents->series.size() > 1)
        warnings.push_back(fmt::format("The folder holds {} series; the one with most slices ({}) was read.",
                                       contents->series.size(), largest.slices()));
    if (contents->unreadable > 0)
        warnings.push_back(fmt::format("{} DICOM file(s) could not be read and were left out. The first: {}",
                                       contents->unreadable, contents->firstFailure->sentence()));
    Result<Study> study = [&]() -> Result<Study> {
        if (largest.files.size() == 1) {
            const auto file = DicomFile::load(largest.files.front().path, false, progress);
            if (!file) return tl::unexpected(file.error());
            return readMultiframe(*file, options, progress);
        }
        auto order = orderSlices(path, largest, options);
        if (!order) return tl::unexpected(order.error());
        return SliceReader(path, std::move(*order), options, progress).read();
    }();
    if (!study) return study;
    study->files = contents->files;
    study->warnings.insert(study->warnings.begin(), warnings.begin(), warnings.end());
    return study;
}

}  // namespace echolucent
