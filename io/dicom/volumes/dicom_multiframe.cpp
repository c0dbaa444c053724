#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <numeric>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/frames/frame_layout.h"
#include "io/dicom/frames/frame_phases.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/dicom/pixels/pixel_statements.h"
#include "io/dicom/volumes/dicom_kretz.h"
#include "io/dicom/volumes/frames_of_parts.h"
#include "io/dicom/volumes/joined_parts.h"
#include "io/kretz/kretz_reader.h"
#include "io/study/value_window.h"
#include "io/voxels/large_volumes.h"
#include "io/voxels/phase_slices.h"
#include "processing/volume/block_mean.h"

namespace echolucent {

namespace {

/// The report's name for a kind of object: "DICOM Enhanced US Volume".
std::string nameOfObject(const std::string& sopClass) {
    const std::string name = objectName(sopClass);
    return "DICOM " + name.substr(name.find(' ') + 1);  // behind the article
}

class MultiframeReader {
public:
    /// `paths` names the files that hold the object, `file` has the header of all frames.
    MultiframeReader(const DicomFile& file, FramesOfParts& frames, std::vector<std::string> paths,
                     const ReadOptions& options, const Progress& progress)
        : m_file(file), m_frames(frames), m_paths(std::move(paths)), m_options(options), m_progress(progress) {}
    Result<Study> read();

private:
    Result<FrameLayout> layOut();
    Result<FrameLayout> layOutAsSlices();
    [[nodiscard]] std::string formatInWords(const FrameLayout& layout) const;
    [[nodiscard]] Result<std::optional<ChosenReduction>> chooseReduction(const FrameLayout& layout) const;
    Result<std::vector<VoxelBytes>> readPhases(const FrameLayout& layout, const std::optional<ChosenReduction>& chosen);

    const DicomFile& m_file;
    FramesOfParts& m_frames;
    std::vector<std::string> m_paths;
    const ReadOptions& m_options;
    const Progress& m_progress;
};

Result<FrameLayout> MultiframeReader::layOut() {
    auto layout =
        layOutFrames(m_file.dataset(), m_file.path(),
                     {static_cast<std::size_t>(m_frames.frames()), m_frames.columns(), m_frames.rows()}, m_progress);
    if (!layout && layout.error().framesCouldBeSlices && m_options.framesAsSlices) return layOutAsSlices();
    return layout;
}

Result<FrameLayout> MultiframeReader::layOutAsSlices() {
    FrameLayout layout;
    const auto count = static_cast<std::size_t>(m_frames.frames());
    const auto groups = readFunctionalGroups(m_file.dataset(), m_file.path(), count, m_progress);
    auto tissue = groups && !groups->empty() ? tissueFramesOf(m_file.path(), *groups) : Result<TissueFrames>({});
    const auto vectors = readFrameVectors(m_file.dataset(), m_file.path(), count);
    if (vectors && !vectors->phases.empty()) {
        layout.phases = vectors->phases;
    } else if (tissue && tissue->frames.size() > 1) {
        layout.phases.push_back(std::move(tissue->frames));
        layout.warnings = std::move(tissue->warnings);
    } else {
        layout.phases.emplace_back(count);
        std::iota(layout.phases[0].begin(), layout.phases[0].end(), std::size_t{0});
    }
    if (vectors) takeVectors(*vectors, layout);
    layout.geometry.size = {m_frames.columns(), m_frames.rows(), static_cast<std::int64_t>(layout.phases[0].size())};
    takeScale(sliceScaleOf(m_file.dataset(), std::nullopt, ""), layout);
    layout.warnings.emplace_back("The frames of a 2D cine are taken as slices: this is no true volume.");
    return layout;
}

/// "DICOM Enhanced US Volume, one file, 3 phases of 64 frames"; of a concatenation "..., 2 files, ...".
std::string MultiframeReader::formatInWords(const FrameLayout& layout) const {
    const std::string object = nameOfObject(m_file.scan().sopClass);
    const std::size_t slices = layout.phases.front().size();
    const std::string files = m_paths.size() == 1 ? "one file" : fmt::format("{} files", m_paths.size());
    if (layout.phases.size() == 1) return fmt::format("{}, {}, {} frames", object, files, slices);
    return fmt::format("{}, {}, {} phases of {} frames", object, files, layout.phases.size(), slices);
}

Result<std::optional<ChosenReduction>> MultiframeReader::chooseReduction(const FrameLayout& layout) const {
    return echolucent::chooseReduction(
        m_file.path(), "(0028,0008) Number of Frames",
        {{m_frames.columns(), m_frames.rows(), static_cast<std::int64_t>(layout.phases[0].size())},
         static_cast<std::int64_t>(layout.phases.size()),
         m_frames.type()},
        m_options);
}

Result<std::vector<VoxelBytes>> MultiframeReader::readPhases(const FrameLayout& layout,
                                                             const std::optional<ChosenReduction>& chosen) {
    const std::size_t slices = layout.phases[0].size();
    if (const auto checked = m_frames.check(m_progress); !checked) return tl::unexpected(checked.error());
    const auto reduction = chosen ? std::optional(chosen->reduction) : std::nullopt;
    std::vector<VoxelBytes> phases;
    std::size_t done = 0;
    for (const auto& order : layout.phases) {
        PhaseSlices voxels(m_frames.type(), {m_frames.columns(), m_frames.rows(), static_cast<std::int64_t>(slices)},
                           reduction);
        for (std::size_t slice = 0; slice < slices; ++slice, ++done) {
            if (m_progress.cancelled())
                return fail(FailureKind::cancelled, m_file.path(), "", "was not read: cancelled");
            m_progress.at(0.9 * static_cast<double>(done) / static_cast<double>(slices * layout.phases.size()));
            if (const auto read = m_frames.readGrey(static_cast<std::int64_t>(order[slice]), voxels.nextSlice()); !read)
                return tl::unexpected(read.error());
            voxels.endSlice();
        }
        phases.push_back(voxels.take());
    }
    return phases;
}

Result<Study> MultiframeReader::read() {
    auto layout = layOut();
    if (!layout) return tl::unexpected(layout.error());
    if (auto few = requirePhases(m_file.path(), layout->phaseSource, static_cast<std::int64_t>(layout->phases.size()));
        !few)
        return tl::unexpected(few.error());
    std::vector<std::size_t> shown;
    for (const auto& order : layout->phases) shown.insert(shown.end(), order.begin(), order.end());
    m_frames.keep(std::move(shown));
    auto chosen = chooseReduction(*layout);
    if (!chosen) return tl::unexpected(chosen.error());
    auto phases = readPhases(*layout, *chosen);
    if (!phases) return tl::unexpected(phases.error());
    StudyParts parts;
    parts.path = m_file.path();
    parts.files = m_paths;
    parts.geometry = layout->geometry;
    parts.sizeSource = "(0028,0011) Columns, (0028,0010) Rows, (0028,0008) Number of Frames";
    parts.typeSource = "(0028,0100) Bits Allocated, (0028,0103) Pixel Representation";
    parts.phasesSource = layout->phaseSource;
    parts.spacingSource = layout->spacingSource;
    parts.inPlaneSpacingKnown = layout->inPlaneSpacingKnown;
    m_frames.sayWhite(parts);
    parts.phaseTimes = layout->phaseTimes;
    parts.phaseSource = layout->phaseSource;
    if (layout->probe) {
        parts.geometry.probe = layout->probe->probe;
        parts.probeSource = layout->probe->source;
    }
    if (*chosen) parts.geometry = reducedGeometry(parts.geometry, (*chosen)->reduction);
    parts.reduction = *std::move(chosen);
    sayLoss(m_file.dataset(), parts);
    sayBurnedInText(m_file.dataset(), false, parts);
    parts.facts = {{"format", formatInWords(*layout), "(0008,0016) SOP Class UID"}};
    for (auto&& fact : layout->facts) parts.facts.push_back(std::move(fact));
    for (auto&& fact : m_frames.facts()) parts.facts.push_back(std::move(fact));
    for (auto&& fact : equipmentFacts(m_file.dataset())) parts.facts.push_back(std::move(fact));
    parts.warnings = layout->warnings;
    for (auto&& warning : m_frames.warnings()) parts.warnings.push_back(std::move(warning));
    keepVoxels(parts, std::move(*phases), m_frames.type(), std::nullopt, m_options);
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

Result<Study> readMultiframe(const DicomFile& file, const ReadOptions& options, const Progress& progress) {
    if (auto kretz = kretzVolumeIn(file)) return readKretz(std::move(*kretz), options, progress);
    auto frames = FramesOfParts::open(file);
    if (!frames) return tl::unexpected(frames.error());
    if (frames->frames() < 2) return singlePicture(file.path());
    return MultiframeReader(file, *frames, {file.path()}, options, progress).read();
}

Result<Study> readConcatenation(const std::vector<std::string>& paths, const ReadOptions& options,
                                const Progress& progress) {
    const auto header = joinedHeader(paths, progress);
    if (!header) return tl::unexpected(header.error());
    auto frames = FramesOfParts::open(paths, progress);
    if (!frames) return tl::unexpected(frames.error());
    if (frames->frames() < 2) return singlePicture(header->path());
    return MultiframeReader(*header, *frames, paths, options, progress).read();
}

}  // namespace echolucent
