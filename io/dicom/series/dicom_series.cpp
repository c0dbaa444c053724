#include <algorithm>
#include <cmath>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_geometry.h"
#include "io/dicom/dicom_names.h"
#include "io/dicom/dicom_pixels.h"
#include "io/dicom/dicom_study.h"
#include "io/dicom/philips_volume.h"
#include "io/dicom/picture_scale.h"
#include "io/dicom/series/large_stack.h"
#include "io/input_file.h"
#include "io/series_list.h"

namespace echolucent {

namespace {

/// Slices in order, with the geometry they share.
struct SliceOrder {
    std::vector<std::string> paths;
    bool rescaled = false;             // whether any slice is
    bool inPlaneSpacingKnown = false;  // where the distance of slices is a guess
    VolumeGeometry geometry;
    std::string spacingSource;
    std::vector<std::string> warnings;
};

/// The order of the entry's files, which stand in the order of slices already.
Result<SliceOrder> orderOf(const SeriesList& list, const SeriesEntry& entry, const ReadOptions& options) {
    if (entry.whyNot && !(entry.whyNot->framesCouldBeSlices && options.framesAsSlices))
        return tl::unexpected(*entry.whyNot);
    SliceOrder order;
    for (const SeriesFile& file : entry.files) {
        order.paths.push_back(file.path);
        order.rescaled = order.rescaled || file.rescaled;
    }
    if (entry.whyNot) {
        order.geometry.spacingKnown = false;
        order.warnings.emplace_back(
            "Pictures without position are taken as slices, in the order of their instance numbers.");
        return order;
    }
    std::vector<SlicePlane> planes;
    for (const SeriesFile& file : entry.files) planes.push_back(*file.plane);
    auto stack = stackSlices(list.path, imagePositionName, planes);
    if (!stack) return tl::unexpected(stack.error());
    order.geometry.origin = stack->origin;
    order.geometry.direction = stack->direction;
    order.geometry.patientFrameKnown = true;  // Image Position (Patient) says where the slices lie
    order.geometry.spacing[2] = stack->spacing;
    order.warnings = stack->warnings;
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
        m_parts.sizeSource = "(0028,0011) Columns, (0028,0010) Rows, number of files";
        m_parts.typeSource = "(0028,0100) Bits Allocated, (0028,0103) Pixel Representation";
        m_parts.spacingSource = m_order.spacingSource;
        m_parts.inPlaneSpacingKnown = m_order.inPlaneSpacingKnown;
        m_parts.warnings.insert(m_parts.warnings.end(), m_order.warnings.begin(), m_order.warnings.end());
        if (m_differentWhite)
            m_parts.warnings.emplace_back("The slices are rescaled by different slopes; each by its own.");
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
        auto frames = DicomFrames::open(file->dataset(), file->path(), file->scan(), m_order.rescaled);
        if (!frames) return tl::unexpected(frames.error());
        const auto bytes = static_cast<std::size_t>(frames->frameBytes());
        std::vector<std::uint8_t> grey(bytes);
        if (const auto read = frames->readGrey(0, grey); !read) return read;
        if (slice == 0)
            if (const auto begun = begin(file->dataset(), *frames); !begun) return begun;
        if (frames->type() != m_type || bytes != m_sliceBytes || frames->bitsStored() != m_bitsStored)
            return fail(FailureKind::unreadable, file->path(), "(0028,0101) Bits Stored",
                        "makes this slice's pixels another type than the first slice's", "Export the series again.");
        std::copy(grey.begin(), grey.end(), m_voxels.begin() + static_cast<std::ptrdiff_t>(slice * bytes));
        m_parts.lossyCompressed = m_parts.lossyCompressed || frames->lossyCompressed();
        keepWhite(*frames);
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
        m_bitsStored = frames.bitsStored();
        m_largestValue = frames.largestValue();
        frames.sayWhite(m_parts);
        m_parts.facts = {{"format", fmt::format("DICOM, {} slices", slices), "files of one series, (0020,000e)"}};
        if (const std::string uid = dicomText(dataset, {0x0008, 0x0016}); !uid.empty())
            m_parts.facts.push_back({"kind of object", objectName(uid), "(0008,0016) SOP Class UID"});
        for (auto&& fact : frames.facts()) m_parts.facts.push_back(std::move(fact));
        for (auto&& fact : equipmentFacts(dataset)) m_parts.facts.push_back(std::move(fact));
        for (auto&& warning : frames.warnings()) m_parts.warnings.push_back(std::move(warning));
        takeSpacing(dataset);
        return {};
    }

    void keepWhite(const DicomFrames& frames) {
        StudyParts said;
        frames.sayWhite(said);
        if (said.window) m_windows.push_back(std::move(*said.window));
        // Slices that are rescaled otherwise reach otherwise far.
        if (m_parts.whiteLevel && said.whiteLevel) m_parts.whiteLevel = std::max(*m_parts.whiteLevel, *said.whiteLevel);
        m_differentWhite = m_differentWhite || frames.largestValue() != m_largestValue;
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
        if (!m_order.geometry.spacingKnown) {
            const auto scale = pictureScaleOf(dataset);
            if (!scale) return;
            m_order.geometry.spacing = scale->spacing;
            m_order.spacingSource = scale->source;
            m_order.inPlaneSpacingKnown = true;
            return;
        }
        std::string source;
        if (const auto spacing = pixelSpacingOf(dataset, source)) {
            m_order.geometry.spacing[0] = (*spacing)[0];
            m_order.geometry.spacing[1] = (*spacing)[1];
            m_order.spacingSource = source + ", slice positions " + imagePositionName;
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
    int m_bitsStored = 0;
    double m_largestValue = 0.0;         // of the first slice
    bool m_differentWhite = false;       // whether other slices are rescaled otherwise
    std::vector<WindowWhite> m_windows;  // of the slices that declare one
    std::vector<std::uint8_t> m_voxels;
};

/// The grey values of one frame as doubles.
std::vector<double> valuesOf(const std::vector<std::uint8_t>& bytes, StoredType type) {
    std::vector<std::vector<std::uint8_t>> one{bytes};
    const ConvertedVoxels converted = convertVoxels(std::move(one), type);
    return std::visit([](const auto& voxels) { return std::vector<double>(voxels.begin(), voxels.end()); },
                      converted.phases.front());
}

/// Means over the pixels that fall into each of the small picture's.
SmallPicture reduced(const std::vector<double>& values, std::int64_t columns, std::int64_t rows, int longestEdge) {
    SmallPicture small;
    const double factor = std::min(1.0, longestEdge / static_cast<double>(std::max(columns, rows)));
    small.width = std::max(1, static_cast<int>(std::lround(factor * static_cast<double>(columns))));
    small.height = std::max(1, static_cast<int>(std::lround(factor * static_cast<double>(rows))));
    std::vector<double> sums(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
    std::vector<double> counts(sums.size());
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column) {
            const auto place =
                static_cast<std::size_t>(row * small.height / rows * small.width + column * small.width / columns);
            sums[place] += values[static_cast<std::size_t>(row * columns + column)];
            counts[place] += 1.0;
        }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    const double white = *std::max_element(sums.begin(), sums.end());
    small.grey.resize(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        small.grey[i] = white > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::max(0.0, sums[i]) / white)) : 0;
    return small;
}

/// The middle slice of a study in memory.
SmallPicture middleOf(const Study& study, int longestEdge) {
    const Volume& volume = *study.phases.front();
    const auto& size = volume.geometry().size;
    std::vector<double> values(static_cast<std::size_t>(size[0] * size[1]));
    const std::int64_t first = size[2] / 2 * size[0] * size[1];
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = volume.storedValue(first + static_cast<std::int64_t>(i));
    return reduced(values, size[0], size[1], longestEdge);
}

Result<SmallPicture> readMiddle(const SeriesEntry& entry, int longestEdge, const Progress& progress) {
    const SeriesFile& middle = entry.files[entry.files.size() / 2];
    const auto input = InputFile::open(middle.path);
    if (!input) return tl::unexpected(input.error());
    const auto file = DicomFile::load(*input, false, progress);
    if (!file) return tl::unexpected(file.error());
    const auto philips = philipsVolumeOf(*file);
    if (philips && *philips) {
        ReadOptions options;
        options.guessNoData = false;
        const auto study = readPhilipsVolume(*input, *file, **philips, options, progress);
        if (!study) return tl::unexpected(study.error());
        return middleOf(*study, longestEdge);
    }
    auto frames = DicomFrames::open(file->dataset(), file->path(), file->scan());
    if (!frames) return tl::unexpected(frames.error());
    std::vector<std::uint8_t> grey(static_cast<std::size_t>(frames->frameBytes()));
    if (const auto read = frames->readGrey(frames->frames() / 2, grey); !read) return tl::unexpected(read.error());
    return reduced(valuesOf(grey, frames->type()), frames->columns(), frames->rows(), longestEdge);
}

}  // namespace

Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry, const ReadOptions& options,
                         const Progress& progress) {
    Result<Study> study = fail(FailureKind::unreadable, list.path, "", "was not read");
    runWithLargeStack([&] {
        if (entry.multiframe) {
            const auto input = InputFile::open(entry.files.front().path);
            study = input ? readDicomFile(*input, options, progress) : Result<Study>(tl::unexpected(input.error()));
            return;
        }
        auto order = orderOf(list, entry, options);
        study = order ? SliceReader(list.path, std::move(*order), options, progress).read()
                      : Result<Study>(tl::unexpected(order.error()));
    });
    if (!study) return study;
    std::vector<std::string> warnings = list.warnings;
    if (list.series.size() > 1)
        warnings.insert(warnings.begin(), fmt::format("There are {} series here; one of {} slices was read.",
                                                      list.series.size(), entry.size[2]));
    study->files = list.files;
    study->warnings.insert(study->warnings.begin(), warnings.begin(), warnings.end());
    return study;
}

Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge, const Progress& progress) {
    Result<SmallPicture> picture = fail(FailureKind::unreadable, entry.files.front().path, "", "was not read");
    runWithLargeStack([&] { picture = readMiddle(entry, longestEdge, progress); });
    return picture;
}

}  // namespace echolucent
