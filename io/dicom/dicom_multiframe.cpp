#include <algorithm>
#include <map>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_geometry.h"
#include "io/dicom/dicom_pixels.h"
#include "io/dicom/dicom_study.h"
#include "io/input_file.h"

namespace echolucent {

namespace {

/// The name of what gave a frame its position, for messages.
std::string positionName(const FramePlacement& placement) {
    const char* name = placement.positionTag.group == 0x3004   ? "Grid Frame Offset Vector"
                       : placement.positionTag.group == 0x0018 ? "Spacing Between Slices"
                                                               : "Image Position";
    return tagText(placement.positionTag) + " " + name;
}

/// The frames of every phase in slice order, and the geometry they share.
struct FrameLayout {
    std::vector<std::vector<std::size_t>> phases;
    VolumeGeometry geometry;
    std::string spacingSource;
    std::optional<double> phaseSeconds;
    std::vector<std::string> warnings;
};

class MultiframeReader {
public:
    MultiframeReader(const DicomFile& file, DicomFrames& frames, const ReadOptions& options, const Progress& progress)
        : m_file(file), m_frames(frames), m_options(options), m_progress(progress) {}
    Result<Study> read();

private:
    Result<FrameLayout> layOut();
    Result<FrameLayout> layOutAsSlices();
    Result<FrameLayout> layOutPlaced(const std::vector<FramePlacement>& placements);
    Result<FrameLayout> stackPhases(const std::map<double, std::vector<std::size_t>>& phases,
                                    const std::vector<FramePlacement>& placements);
    std::vector<std::size_t> framesOfOneDataType(const std::vector<FramePlacement>& placements, FrameLayout& layout);
    Result<std::vector<std::vector<std::uint8_t>>> readPhases(const FrameLayout& layout);

    const DicomFile& m_file;
    DicomFrames& m_frames;
    const ReadOptions& m_options;
    const Progress& m_progress;
};

Result<FrameLayout> MultiframeReader::layOut() {
    const auto count = static_cast<std::size_t>(m_frames.frames());
    auto placements = functionalGroupPlacements(m_file.dataset(), count, m_progress);
    if (m_progress.cancelled()) return fail(FailureKind::cancelled, m_file.path(), "", "was not read: cancelled");
    const bool placed = placements.size() == count &&
                        std::all_of(placements.begin(), placements.end(), [](const FramePlacement& placement) {
                            return placement.position && placement.orientation;
                        });
    if (!placed) placements = classicPlacements(m_file.dataset(), count);
    if (!placements.empty()) return layOutPlaced(placements);
    if (m_options.framesAsSlices) return layOutAsSlices();
    return framesWithoutGeometry(m_file.path(),
                                 fmt::format("is a 2D cine of {} frames without volume geometry", count));
}

Result<FrameLayout> MultiframeReader::layOutAsSlices() {
    FrameLayout layout;
    layout.phases.emplace_back(static_cast<std::size_t>(m_frames.frames()));
    for (std::size_t frame = 0; frame < layout.phases[0].size(); ++frame) layout.phases[0][frame] = frame;
    layout.geometry.size = {m_frames.columns(), m_frames.rows(), m_frames.frames()};
    layout.geometry.spacingKnown = false;
    layout.warnings.push_back("The frames of a 2D cine are taken as slices: this is no true volume.");
    return layout;
}

std::vector<std::size_t> MultiframeReader::framesOfOneDataType(const std::vector<FramePlacement>& placements,
                                                               FrameLayout& layout) {
    std::string wanted = placements.front().dataType;
    const bool tissue = std::any_of(placements.begin(), placements.end(), [](const FramePlacement& placement) {
        return placement.dataType == "TISSUE_INTENSITY";
    });
    if (tissue) wanted = "TISSUE_INTENSITY";
    std::vector<std::size_t> kept;
    for (std::size_t frame = 0; frame < placements.size(); ++frame)
        if (placements[frame].dataType == wanted) kept.push_back(frame);
    if (kept.size() < placements.size())
        layout.warnings.push_back(fmt::format("{} of {} frames show {} and were read; the others show something else.",
                                              kept.size(), placements.size(), wanted));
    return kept;
}

Result<FrameLayout> MultiframeReader::layOutPlaced(const std::vector<FramePlacement>& placements) {
    FrameLayout layout;
    const auto kept = framesOfOneDataType(placements, layout);
    std::map<double, std::vector<std::size_t>> phases;
    const bool timed = std::all_of(kept.begin(), kept.end(), [&](std::size_t frame) { return placements[frame].time; });
    for (const std::size_t frame : kept) phases[timed ? *placements[frame].time : 0.0].push_back(frame);
    const std::size_t slices = phases.begin()->second.size();
    for (const auto& [time, frames] : phases)
        if (frames.size() != slices)
            return fail(FailureKind::unreadable, m_file.path(), "(5200,9230) Per-frame Functional Groups",
                        fmt::format("gives {} slices at one time and {} at another", slices, frames.size()),
                        "Export the volume again.");
    if (slices < 2) {
        if (m_options.framesAsSlices) return layOutAsSlices();
        return framesWithoutGeometry(m_file.path(),
                                     fmt::format("is a 2D cine: its {} frames show one plane over time", kept.size()));
    }
    auto stacked = stackPhases(phases, placements);
    if (!stacked) return stacked;
    stacked->warnings.insert(stacked->warnings.begin(), layout.warnings.begin(), layout.warnings.end());
    if (phases.size() > 1 && !placements[kept.front()].timeIsIndex)
        stacked->phaseSeconds =
            (phases.rbegin()->first - phases.begin()->first) / static_cast<double>(phases.size() - 1);
    return stacked;
}

Result<FrameLayout> MultiframeReader::stackPhases(const std::map<double, std::vector<std::size_t>>& phases,
                                                  const std::vector<FramePlacement>& placements) {
    FrameLayout layout;
    std::optional<SliceStack> firstStack;
    for (const auto& [time, frames] : phases) {
        std::vector<SlicePlane> planes;
        for (const std::size_t frame : frames)
            planes.push_back({*placements[frame].position, (*placements[frame].orientation)[0],
                              (*placements[frame].orientation)[1]});
        auto stack = stackSlices(m_file.path(), positionName(placements[frames.front()]), planes);
        if (!stack) return tl::unexpected(stack.error());
        if (!firstStack) firstStack = *stack;
        if (!(length(stack->origin - firstStack->origin) <= 0.1 * firstStack->spacing &&
              std::abs(stack->spacing - firstStack->spacing) <= 0.1 * firstStack->spacing))
            return fail(FailureKind::unreadable, m_file.path(), positionName(placements[frames.front()]),
                        "changes from phase to phase", "Export one phase, or all on one grid.");
        std::vector<std::size_t> ordered;
        for (const std::size_t index : stack->order) ordered.push_back(frames[index]);
        layout.phases.push_back(std::move(ordered));
    }
    layout.warnings = firstStack->warnings;
    layout.geometry.size = {m_frames.columns(), m_frames.rows(), static_cast<std::int64_t>(layout.phases[0].size())};
    layout.geometry.origin = firstStack->origin;
    layout.geometry.direction = firstStack->direction;
    layout.geometry.patientFrameKnown = placements[layout.phases[0][0]].orientationInPatient;
    std::string source = "(0028,9110) Pixel Measures";
    auto spacing = placements[layout.phases[0][0]].pixelSpacing;
    if (!spacing) spacing = pixelSpacingOf(m_file.dataset(), source);
    if (spacing) {
        layout.geometry.spacing = {(*spacing)[0], (*spacing)[1], firstStack->spacing};
        layout.spacingSource = source + ", slice positions";
    } else {
        layout.geometry.spacingKnown = false;
    }
    return layout;
}

Result<std::vector<std::vector<std::uint8_t>>> MultiframeReader::readPhases(const FrameLayout& layout) {
    const auto frameBytes = static_cast<std::size_t>(m_frames.frameBytes());
    const std::size_t slices = layout.phases[0].size();
    const auto total = checkedProduct(m_frames.frameBytes(), static_cast<std::int64_t>(slices * layout.phases.size()));
    const auto memory = requireMemory(m_file.path(), "(0028,0008) Number of Frames",
                                      total ? static_cast<std::uint64_t>(*total) : ~std::uint64_t{0});
    if (!memory) return tl::unexpected(memory.error());
    // The first frame is decoded before memory for all of them is taken: a false header is found out here.
    std::vector<std::uint8_t> frame(frameBytes);
    if (const auto read = m_frames.readGrey(0, frame); !read) return tl::unexpected(read.error());
    std::vector<std::vector<std::uint8_t>> phases;
    std::size_t done = 0;
    for (const auto& order : layout.phases) {
        std::vector<std::uint8_t> voxels(frameBytes * slices);
        for (std::size_t slice = 0; slice < slices; ++slice, ++done) {
            if (m_progress.cancelled())
                return fail(FailureKind::cancelled, m_file.path(), "", "was not read: cancelled");
            m_progress.at(0.9 * static_cast<double>(done) / static_cast<double>(slices * layout.phases.size()));
            const auto read = m_frames.readGrey(static_cast<std::int64_t>(order[slice]),
                                                std::span(voxels).subspan(slice * frameBytes, frameBytes));
            if (!read) return tl::unexpected(read.error());
        }
        phases.push_back(std::move(voxels));
    }
    return phases;
}

Result<Study> MultiframeReader::read() {
    auto layout = layOut();
    if (!layout) return tl::unexpected(layout.error());
    auto phases = readPhases(*layout);
    if (!phases) return tl::unexpected(phases.error());
    StudyParts parts;
    parts.path = m_file.path();
    parts.files = {m_file.path()};
    parts.geometry = layout->geometry;
    parts.spacingSource = layout->spacingSource;
    parts.voxels = convertVoxels(std::move(*phases), m_frames.type());
    m_frames.sayWhite(parts);
    parts.phaseSeconds = layout->phaseSeconds;
    parts.phaseSource = "(0020,930d) Temporal Position Time Offset";
    parts.lossyCompressed = m_frames.lossyCompressed();
    parts.facts = {{"format", "DICOM, one multi-frame file", ""}};
    for (auto&& fact : m_frames.facts()) parts.facts.push_back(std::move(fact));
    for (auto&& fact : equipmentFacts(m_file.dataset())) parts.facts.push_back(std::move(fact));
    parts.warnings = layout->warnings;
    for (auto&& warning : m_frames.warnings()) parts.warnings.push_back(std::move(warning));
    return assembleStudy(std::move(parts), m_options, m_progress);
}

}  // namespace

std::vector<ImportFact> equipmentFacts(DcmItem& dataset) {
    std::vector<ImportFact> facts;
    for (const auto& [name, tag] :
         {std::pair{"modality", DicomTag{0x0008, 0x0060}}, std::pair{"manufacturer", DicomTag{0x0008, 0x0070}},
          std::pair{"model", DicomTag{0x0008, 0x1090}}})
        if (auto text = dicomText(dataset, tag); !text.empty()) facts.push_back({name, std::move(text), tagText(tag)});
    return facts;
}

tl::unexpected<Failure> framesWithoutGeometry(const std::string& path, const std::string& problem) {
    auto refused = fail(FailureKind::unreadable, path, "", problem,
                        "Add --frames-as-slices to take its pictures as slices of unknown spacing.");
    refused.value().framesCouldBeSlices = true;
    return refused;
}

Result<Study> readMultiframe(const DicomFile& file, const ReadOptions& options, const Progress& progress) {
    auto frames = DicomFrames::open(file.dataset(), file.path(), file.scan());
    if (!frames) return tl::unexpected(frames.error());
    if (frames->frames() < 2)
        return fail(FailureKind::unreadable, file.path(), "", "holds a single 2D picture, not a volume",
                    "Open the folder that holds all slices, or a multi-frame file.");
    return MultiframeReader(file, *frames, options, progress).read();
}

}  // namespace echolucent
