#include <algorithm>
#include <set>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/dicom/pixels/dicom_pixels.h"
#include "io/dicom/pixels/pixel_statements.h"
#include "io/dicom/series/large_stack.h"
#include "io/dicom/series/series_entries.h"
#include "io/files/files_below.h"
#include "io/files/input_file.h"
#include "io/study/series_list.h"
#include "io/study/study_assembly.h"
#include "io/study/value_window.h"
#include "io/voxels/large_volumes.h"
#include "io/voxels/phase_slices.h"
#include "processing/motion/phase_times.h"
#include "processing/volume/block_mean.h"

namespace echolucent {

namespace {

/// Slices in order, with the geometry they share.
struct SliceOrder {
    std::vector<SeriesFile> files;  // phase after phase
    SeriesPhases phases;
    bool rescaled = false;             // whether any slice is rescaled
    bool padded = false;               // whether any slice states the value of pixels that are no data
    bool differentlyRescaled = false;  // whether slices differ in their rescaling
    bool inPlaneSpacingKnown = false;  // whether pixels have a known size although the distance of slices is a guess
    VolumeGeometry geometry;
    std::string spacingSource;
    std::vector<std::string> warnings;
};

/// Warns if instance numbers leave the order open or skip pictures. Only these numbers order the files.
void sayInstances(const std::vector<SeriesFile>& files, std::vector<std::string>& warnings) {
    std::size_t same = 0, skips = 0;
    for (std::size_t i = 1; i < files.size(); ++i) {
        if (files[i].instance == files[i - 1].instance) ++same;
        if (files[i].instance - files[i - 1].instance > 1) ++skips;
    }
    if (same > 0)
        warnings.push_back(fmt::format(
            "{} pictures have the instance number of another or none, so that their order is not known.", same));
    if (skips > 0)
        warnings.push_back(
            fmt::format("The instance numbers are not consecutive ({} gaps): pictures may be missing.", skips));
}

/// The files of the entry, which are already in the order of slices, and the geometry of their stack. If the entry is
/// no volume, its pictures are taken as slices.
Result<SliceOrder> orderOf(const SeriesList& list, const SeriesEntry& entry) {
    const auto few = requirePhases(list.path, entry.phases.source, entry.phases.count);
    if (!few) return tl::unexpected(few.error());
    SliceOrder order;
    order.files = entry.files;
    order.phases = entry.phases;
    const Rescale* first = nullptr;
    for (const SeriesFile& file : entry.files) {
        if (file.damage) continue;
        if (first == nullptr) first = &file.rescale;
        order.rescaled = order.rescaled || !file.rescale.isIdentity();
        order.padded = order.padded || file.padded;
        order.differentlyRescaled = order.differentlyRescaled || file.rescale != *first;
    }
    if (entry.whyNot) {
        order.geometry.spacingKnown = false;
        order.warnings.emplace_back(
            "Pictures without position are taken as slices, in the order of their instance numbers.");
        sayInstances(entry.files, order.warnings);
        return order;
    }
    std::vector<SlicePlane> planes;
    const auto slices = static_cast<std::size_t>(entry.size[2]);
    for (std::size_t slice = 0; slice < slices; ++slice) planes.push_back(*entry.files[slice].plane);
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
        const std::size_t slices = m_order.files.size();
        for (std::size_t slice = 0; slice < slices; ++slice) {
            if (m_progress.cancelled())
                return fail(FailureKind::cancelled, m_parts.path, "", "was not read: cancelled");
            m_progress.at(0.3 + 0.6 * static_cast<double>(slice) / static_cast<double>(slices));
            if (const auto done = readOrMiss(slice); !done) return tl::unexpected(done.error());
        }
        if (auto tooFew = whyTooFew()) return tl::unexpected(*std::move(tooFew));
        m_parts.geometry =
            m_parts.reduction ? reducedGeometry(m_order.geometry, m_parts.reduction->reduction) : m_order.geometry;
        m_parts.sizeSource = "(0028,0011) Columns, (0028,0010) Rows, number of files";
        m_parts.typeSource = "(0028,0100) Bits Allocated, (0028,0103) Pixel Representation";
        m_parts.phasesSource = m_order.phases.source;
        sayTimes();
        m_parts.spacingSource = m_order.spacingSource;
        m_parts.inPlaneSpacingKnown = m_order.inPlaneSpacingKnown;
        sayMissing();
        sayNotes();
        m_parts.warnings.insert(m_parts.warnings.end(), m_order.warnings.begin(), m_order.warnings.end());
        if (m_order.differentlyRescaled)
            m_parts.warnings.emplace_back(
                "The slices are rescaled by different slopes or intercepts; each by its own.");
        shareWindow();
        m_phases.push_back(m_slices->take());
        keepVoxels(m_parts, std::move(m_phases), m_type, std::nullopt, m_options);
        return assembleStudy(std::move(m_parts), m_options, m_progress);
    }

private:
    /// The slices of each phase.
    [[nodiscard]] std::size_t slicesOfPhase() const {
        return m_order.files.size() / static_cast<std::size_t>(m_order.phases.count);
    }

    /// Begins the next phase if the one before is full.
    void beginPhase(std::size_t slice) {
        if (!m_slices || slice == 0 || slice % slicesOfPhase() != 0) return;
        m_phases.push_back(m_slices->take());
        m_slices.emplace(m_type, m_order.geometry.size, reductionTaken());
    }

    [[nodiscard]] std::optional<Reduction> reductionTaken() const {
        return m_parts.reduction ? std::optional(m_parts.reduction->reduction) : std::nullopt;
    }

    void sayTimes() {
        const std::vector<double>& seconds = m_order.phases.seconds;
        if (seconds.empty()) return;
        m_parts.phaseTimes = phaseTimesAt(seconds);
        m_parts.phaseSource = m_order.phases.timeSource;
    }

    /// Reads a slice, or notes that it cannot be read. Fails if the person cancelled, if the slice is of another type
    /// than the first readable one, or if the memory is too small for the series.
    Result<void> readOrMiss(std::size_t slice) {
        beginPhase(slice);
        const SeriesFile& file = m_order.files[slice];
        const auto grey = file.damage ? Result<Slice>(tl::unexpected(*file.damage)) : decode(file);
        if (grey) return take(slice, *grey);
        if (grey.error().kind == FailureKind::cancelled) return tl::unexpected(grey.error());
        m_missing.push_back(slice);
        if (m_missing.size() == 1) m_whyMissing = grey.error();
        if (m_slices) m_slices->skipSlice();
        return {};
    }

    /// A decoded slice. The frames keep the file's data set.
    struct Slice {
        DicomFile file;
        DicomFrames frames;
        std::vector<std::uint8_t> grey;
    };

    Result<Slice> decode(const SeriesFile& one) {
        auto file = DicomFile::load(one.path, false, m_progress);
        if (!file) return tl::unexpected(file.error());
        auto frames = DicomFrames::open(file->dataset(), file->path(), file->scan(),
                                        {.rescaled = m_order.rescaled, .padded = m_order.padded});
        if (!frames) return tl::unexpected(frames.error());
        std::vector<std::uint8_t> grey(static_cast<std::size_t>(frames->frameBytes()));
        if (const auto read = frames->readGrey(0, grey); !read) return tl::unexpected(read.error());
        return Slice{std::move(*file), std::move(*frames), std::move(grey)};
    }

    Result<void> take(std::size_t slice, const Slice& read) {
        const auto& [file, frames, grey] = read;
        const std::size_t bytes = grey.size();
        if (!m_slices)
            if (const auto begun = begin(file.dataset(), frames, slice); !begun) return begun;
        const bool sameType = frames.type() == m_type && bytes == m_sliceBytes;
        if (!sameType || frames.bitsStored() != m_bitsStored)
            return fail(FailureKind::unreadable, file.path(),
                        sameType ? "(0028,0101) Bits Stored" : "(0028,0100) Bits Allocated or (0028,0103) sign",
                        "makes this slice's pixels another type than the first slice's", "Export the series again.");
        std::ranges::copy(grey, m_slices->nextSlice().begin());
        m_slices->endSlice();
        sayLoss(file.dataset(), m_parts);
        sayBurnedInText(file.dataset(), false, m_parts);
        keepWhite(frames);
        for (const std::string& warning : frames.warnings()) note(warning);
        return {};
    }

    [[nodiscard]] std::vector<std::string> missingPaths() const {
        std::vector<std::string> paths;
        for (const std::size_t slice : m_missing) paths.push_back(m_order.files[slice].path);
        return paths;
    }

    [[nodiscard]] std::optional<Failure> whyTooFew() const {
        if (m_missing.empty()) return std::nullopt;
        return tooFewWhole(m_parts.path, missingPaths(), m_order.files.size(), *m_whyMissing);
    }

    void sayMissing() {
        if (m_missing.empty()) return;
        const std::string& element = m_whyMissing->element;
        m_parts.warnings.push_back(
            fmt::format("{} of {} slices could not be read and are shown as no data{}: {}. The first {}{}.",
                        m_missing.size(), m_order.files.size(), m_order.phases.count > 1 ? " in all phases" : "",
                        filesInWords(missingPaths()), element.empty() ? "" : element + " ", m_whyMissing->problem));
        m_parts.missingSlices = missingOfKept();
    }

    /// The slices that are unreadable in any phase, in rising order. Of a reduced volume, those of its slices of which
    /// every file is unreadable.
    [[nodiscard]] std::vector<std::size_t> missingOfKept() const {
        std::set<std::size_t> unreadable;
        for (const std::size_t slice : m_missing) unreadable.insert(slice % slicesOfPhase());
        const std::vector<std::size_t> stored(unreadable.begin(), unreadable.end());
        if (!m_parts.reduction) return stored;
        const auto thick = static_cast<std::size_t>(m_parts.reduction->reduction.by[2]);
        std::vector<std::size_t> whole;
        for (std::size_t index = 0; index < stored.size();) {
            const std::size_t layer = stored[index] / thick;
            const std::size_t slices = std::min(thick, slicesOfPhase() - layer * thick);
            std::size_t missing = 0;
            for (; index < stored.size() && stored[index] / thick == layer; ++index) ++missing;
            if (missing == slices) whole.push_back(layer);
        }
        return whole;
    }

    /// Takes type and size of all slices from the first readable one. The `before` slices before it were not readable.
    Result<void> begin(DcmItem& dataset, const DicomFrames& frames, std::size_t before) {
        m_type = frames.type();
        m_sliceBytes = static_cast<std::size_t>(frames.frameBytes());
        const auto slices = static_cast<std::int64_t>(slicesOfPhase());
        const std::int64_t phases = m_order.phases.count;
        auto chosen =
            chooseReduction(m_parts.path, "", {{frames.columns(), frames.rows(), slices}, phases, m_type}, m_options);
        if (!chosen) return tl::unexpected(chosen.error());
        m_parts.reduction = *std::move(chosen);
        m_order.geometry.size = {frames.columns(), frames.rows(), slices};
        m_slices.emplace(m_type, m_order.geometry.size, reductionTaken());
        for (std::size_t slice = 0; slice < before; ++slice) {
            beginPhase(slice);
            m_slices->skipSlice();
        }
        beginPhase(before);
        m_bitsStored = frames.bitsStored();
        frames.sayWhite(m_parts);
        m_parts.facts = {{"format",
                          phases == 1 ? fmt::format("DICOM, {} slices", slices)
                                      : fmt::format("DICOM, {} phases of {} slices", phases, slices),
                          "files of one series, (0020,000e)"}};
        if (const std::string uid = dicomText(dataset, {0x0008, 0x0016}); !uid.empty())
            m_parts.facts.push_back({"kind of object", objectName(uid), "(0008,0016) SOP Class UID"});
        for (auto&& fact : frames.facts()) m_parts.facts.push_back(std::move(fact));
        for (auto&& fact : equipmentFacts(dataset)) m_parts.facts.push_back(std::move(fact));
        takeSpacing(dataset);
        return {};
    }

    /// Counts how many slices have this warning; of more than mostNotes different ones, only how many are left out.
    void note(const std::string& sentence) {
        const auto known = std::ranges::find(m_notes, sentence, &SliceNote::sentence);
        if (known != m_notes.end())
            ++known->slices;
        else if (m_notes.size() < mostNotes)
            m_notes.push_back({sentence, 1});
        else
            ++m_notesLeftOut;
    }

    void sayNotes() {
        const std::size_t slices = m_order.files.size() - m_missing.size();
        for (const SliceNote& one : m_notes)
            m_parts.warnings.push_back(saidOf(one.sentence, one.slices, slices, "slices"));
        if (m_notesLeftOut > 0)
            m_parts.warnings.push_back(fmt::format("{} more notes on single slices are left out.", m_notesLeftOut));
    }

    void keepWhite(const DicomFrames& frames) {
        StudyParts said;
        frames.sayWhite(said);
        if (said.window) m_windows.push_back(std::move(*said.window));
        widenLevels(m_parts, said);
    }

    /// The slices share one window: the one whose white is the median.
    void shareWindow() {
        if (m_windows.empty()) return;
        std::sort(m_windows.begin(), m_windows.end(),
                  [](const DisplayWindow& a, const DisplayWindow& b) { return a.white < b.white; });
        if (m_windows.front().white < m_windows.back().white)
            m_parts.warnings.push_back(fmt::format(
                "The slices declare windows with white from {:.6g} to {:.6g}; the one in their middle is asked.",
                m_windows.front().white, m_windows.back().white));
        m_parts.window = m_windows[m_windows.size() / 2];
    }

    void takeSpacing(DcmItem& dataset) {
        VolumeGeometry& geometry = m_order.geometry;
        const auto distance = geometry.spacingKnown ? std::optional(geometry.spacing[2]) : std::nullopt;
        SliceScale scale = sliceScaleOf(dataset, distance, std::string("slice positions ") + imagePositionName);
        geometry.spacing = scale.spacing;
        geometry.spacingKnown = scale.spacingKnown;
        m_order.spacingSource = scale.source;
        m_order.inPlaneSpacingKnown = scale.inPlaneKnown && !scale.spacingKnown;
        for (auto&& warning : scale.warnings) m_order.warnings.push_back(std::move(warning));
    }

    struct SliceNote {
        std::string sentence;
        std::size_t slices = 0;
    };
    static constexpr std::size_t mostNotes = 20;

    SliceOrder m_order;
    const ReadOptions& m_options;
    const Progress& m_progress;
    StudyParts m_parts;
    StoredType m_type = StoredType::uint8;
    std::size_t m_sliceBytes = 0;
    int m_bitsStored = 0;
    std::vector<SliceNote> m_notes;
    std::size_t m_notesLeftOut = 0;
    std::vector<std::size_t> m_missing;    // unreadable slices
    std::optional<Failure> m_whyMissing;   // of the first of them
    std::vector<DisplayWindow> m_windows;  // of the slices with a window
    std::vector<VoxelBytes> m_phases;      // those before the one that is read
    std::optional<PhaseSlices> m_slices;   // of the phase that is read
};

}  // namespace

Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry, const ReadOptions& options,
                         const Progress& progress) {
    Result<Study> study = fail(FailureKind::unreadable, list.path, "", "was not read");
    runWithLargeStack([&] {
        const bool asSlices = entry.whyNot && entry.whyNot->framesCouldBeSlices && options.framesAsSlices;
        if (entry.whyNot && !asSlices) {
            study = tl::unexpected(*entry.whyNot);
            return;
        }
        if (entry.multiframe && entry.files.size() > 1) {
            std::vector<std::string> paths;
            for (const SeriesFile& file : entry.files) paths.push_back(file.path);
            study = readConcatenation(paths, options, progress);
            return;
        }
        if (entry.multiframe) {
            const auto input = InputFile::open(entry.files.front().path);
            study = input ? readDicomFile(*input, options, progress) : Result<Study>(tl::unexpected(input.error()));
            return;
        }
        auto order = orderOf(list, entry);
        study = order ? SliceReader(list.path, std::move(*order), options, progress).read()
                      : Result<Study>(tl::unexpected(order.error()));
    });
    if (!study) return study;
    std::vector<std::string> warnings = list.warnings;
    warnings.insert(warnings.begin(), entry.notes.begin(), entry.notes.end());
    if (list.series.size() > 1)
        warnings.insert(warnings.begin(), fmt::format("There are {} series here; that of {} was read.",
                                                      list.series.size(), sizeInWords(entry)));
    study->files = list.files;
    study->warnings.insert(study->warnings.begin(), warnings.begin(), warnings.end());
    return study;
}

}  // namespace echolucent
