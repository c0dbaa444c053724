#include "io/dicom/frames/frame_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "io/dicom/frames/dicom_geometry.h"
#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/frames/frame_phases.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/files/input_problems.h"
#include "io/study/slice_stack.h"

namespace echolucent {

namespace {

const std::string positionVolumeName = "(0020,9301) Image Position (Volume)";
const std::string positionPatientName = "(0020,0032) Image Position (Patient)";

/// Puts the times of phases into `layout`, and names the attributes that state them.
void takeTimes(const DicomTimes& times, FrameLayout& layout) {
    if (times.source != layout.phaseSource) layout.phaseSource = times.source + "; phases by " + layout.phaseSource;
    layout.phaseTimes = phaseTimesAt(times.seconds);
}

class GroupLayout {
public:
    GroupLayout(DcmItem& dataset, const std::string& path, const std::vector<FrameGroups>& groups)
        : m_dataset(dataset), m_path(path), m_groups(groups) {}

    Result<FrameLayout> layOut(std::int64_t columns, std::int64_t rows);

private:
    Result<void> takePhases();
    Result<void> choosePlanes();
    Result<void> stackPhases();
    Result<void> checkSlicePlaces() const;
    Result<void> setSpacing();
    Result<void> findProbe();
    Result<std::optional<GridInVolumeFrame>> gridInVolumeFrame();

    [[nodiscard]] const StatedPlane& planeOf(std::size_t frame) const {
        return m_inPatient ? m_groups[frame].inPatient : m_groups[frame].inVolume;
    }
    [[nodiscard]] const std::string& positionName() const {
        return m_inPatient ? positionPatientName : positionVolumeName;
    }
    [[nodiscard]] tl::unexpected<Failure> refuse(const std::string& element, const std::string& problem) const {
        return fail(FailureKind::unreadable, m_path, element, problem, exportAgain);
    }

    DcmItem& m_dataset;
    const std::string& m_path;
    const std::vector<FrameGroups>& m_groups;
    std::vector<FrameDimension> m_dimensions;
    std::vector<std::size_t> m_tissue;
    bool m_inPatient = false;
    double m_betweenSlices = 1.0;  // mm, between the positions
    FrameLayout m_layout;
};

Result<void> GroupLayout::takePhases() {
    auto tissue = tissueFramesOf(m_path, m_groups);
    if (!tissue) return tl::unexpected(tissue.error());
    m_tissue = std::move(tissue->frames);
    m_layout.warnings = std::move(tissue->warnings);
    if (!tissue->story.empty()) m_layout.facts.push_back({"data type", tissue->story, tagText(dataTypeTag)});
    m_dimensions = readFrameDimensions(m_dataset);
    auto split = splitIntoPhases(m_path, m_dimensions, m_groups, m_tissue);
    if (!split) return tl::unexpected(split.error());
    m_layout.phases = std::move(split->phases);
    m_layout.phaseSource = split->source;
    m_layout.warnings.insert(m_layout.warnings.end(), split->warnings.begin(), split->warnings.end());
    if (split->times) takeTimes(*split->times, m_layout);
    constexpr DicomTag organizationTag{0x0020, 0x9311};
    if (m_layout.phases.size() > 1 && dicomText(m_dataset, organizationTag) == "3D")
        m_layout.warnings.push_back(
            fmt::format("The file calls itself one volume ((0020,9311) is 3D), but its frames are of {} phases.",
                        m_layout.phases.size()));
    return {};
}

Result<void> GroupLayout::choosePlanes() {
    const auto inPatient = static_cast<std::size_t>(
        std::ranges::count_if(m_tissue, [&](std::size_t frame) { return m_groups[frame].inPatient.isComplete(); }));
    m_inPatient = inPatient == m_tissue.size();
    if (m_inPatient) return {};
    for (const std::size_t frame : m_tissue)
        if (!m_groups[frame].inVolume.isComplete())
            return refuse(positionVolumeName,
                          fmt::format("or its orientation (0020,9302) is missing for frame {}", frame + 1));
    if (inPatient > 0)
        m_layout.warnings.push_back(
            fmt::format("Only {} of {} frames have a place in the patient, so that none was taken from them.",
                        inPatient, m_tissue.size()));
    else if (dicomText(m_dataset, {0x0020, 0x9307}) == "PATIENT")
        m_layout.warnings.emplace_back(
            "The file says that its place in the patient is known ((0020,9307) is PATIENT), but no frame has one.");
    return {};
}

Result<void> GroupLayout::stackPhases() {
    std::optional<SliceStack> firstStack;
    for (auto& frames : m_layout.phases) {
        std::vector<SlicePlane> planes;
        for (const std::size_t frame : frames) {
            const StatedPlane& plane = planeOf(frame);
            planes.push_back({*plane.position, (*plane.orientation)[0], (*plane.orientation)[1]});
        }
        auto stack = stackSlices(m_path, positionName(), planes);
        if (!stack) return tl::unexpected(stack.error());
        if (!firstStack) firstStack = *stack;
        if (!(length(stack->origin - firstStack->origin) <= 0.1 * firstStack->spacing &&
              std::abs(stack->spacing - firstStack->spacing) <= 0.1 * firstStack->spacing &&
              cv::norm(stack->direction - firstStack->direction) <= 0.01))
            return fail(FailureKind::unreadable, m_path, positionName(), "changes from phase to phase",
                        "Export one phase, or all on one grid.");
        std::vector<std::size_t> ordered;
        for (const std::size_t index : stack->order) ordered.push_back(frames[index]);
        frames = std::move(ordered);
    }
    m_layout.warnings.insert(m_layout.warnings.end(), firstStack->warnings.begin(), firstStack->warnings.end());
    m_layout.geometry.size[2] = static_cast<std::int64_t>(m_layout.phases.front().size());
    m_layout.geometry.origin = firstStack->origin;
    m_layout.geometry.direction = firstStack->direction;
    m_layout.geometry.patientFrameKnown = m_inPatient;
    if (auto checked = checkSlicePlaces(); !checked) return checked;
    m_betweenSlices = firstStack->spacing;
    return setSpacing();
}

/// Refuses position indices that differ from phase to phase.
Result<void> GroupLayout::checkSlicePlaces() const {
    const auto& first = m_layout.phases.front();
    for (std::size_t phase = 1; phase < m_layout.phases.size(); ++phase)
        for (std::size_t slice = 0; slice < first.size(); ++slice) {
            const std::size_t frame = m_layout.phases[phase][slice];
            if (positionIndexOf(m_dimensions, m_groups[frame]) != positionIndexOf(m_dimensions, m_groups[first[slice]]))
                return refuse(tagText(indexValuesTag) + " Dimension Index Values",
                              fmt::format("counts frames {} and {} as different places, where {} is the same",
                                          first[slice] + 1, frame + 1, positionName()));
        }
    return {};
}

Result<void> GroupLayout::setSpacing() {
    const FrameGroups& first = m_groups[m_tissue.front()];
    const auto spacing = first.pixelSpacing;
    for (const std::size_t frame : m_tissue)
        if (m_groups[frame].pixelSpacing != spacing)
            return refuse("(0028,0030) Pixel Spacing", "changes from frame to frame");
    if (spacing) {
        m_layout.geometry.spacing = {(*spacing)[0], (*spacing)[1], m_betweenSlices};
        m_layout.spacingSource = "(0028,9110) Pixel Measures, slice positions";
    } else {
        takeScale(sliceScaleOf(m_dataset, m_betweenSlices, "slice positions"), m_layout);
    }
    if (first.betweenSlices && std::abs(*first.betweenSlices - m_betweenSlices) > 0.01 * m_betweenSlices)
        m_layout.warnings.push_back(fmt::format(
            "(0018,0088) Spacing Between Slices is {:.4g} mm, but the slices' positions are {:.4g} mm apart; "
            "the positions were taken.",
            *first.betweenSlices, m_betweenSlices));
    return {};
}

/// The grid in the volume's frame of reference, in which apex and transducer are stated; no value if a frame of the
/// first phase has no place in it. Fails if the slices lie otherwise there than in the patient.
Result<std::optional<GridInVolumeFrame>> GroupLayout::gridInVolumeFrame() {
    const VolumeGeometry& geometry = m_layout.geometry;
    if (!m_inPatient) return GridInVolumeFrame{geometry.origin, geometry.direction};
    const std::vector<std::size_t>& frames = m_layout.phases.front();
    if (!std::ranges::all_of(frames, [&](std::size_t frame) { return m_groups[frame].inVolume.isComplete(); }))
        return std::nullopt;
    const StatedPlane& first = m_groups[frames.front()].inVolume;
    const auto& [row, column] = *first.orientation;
    const Vec3 normal = row.cross(column);
    const StatedPlane& firstInPatient = m_groups[frames.front()].inPatient;
    const auto& [patientRow, patientColumn] = *firstInPatient.orientation;
    const std::array axes{std::pair{row, patientRow}, std::pair{column, patientColumn},
                          std::pair{normal, patientRow.cross(patientColumn)}};
    for (std::size_t slice = 1; slice < frames.size(); ++slice) {
        const std::size_t frame = frames[slice];
        const double tolerance = 0.01 * m_betweenSlices * static_cast<double>(slice);
        const Vec3 inVolume = *m_groups[frame].inVolume.position - *first.position;
        const Vec3 inPatient = *m_groups[frame].inPatient.position - *firstInPatient.position;
        for (const auto& [volumeAxis, patientAxis] : axes)
            if (!(std::abs(inVolume.dot(volumeAxis) - inPatient.dot(patientAxis)) <= tolerance))
                return refuse(positionVolumeName,
                              fmt::format("puts frame {} at another distance from frame {} than {} does", frame + 1,
                                          frames.front() + 1, positionPatientName));
    }
    GridInVolumeFrame grid{*first.position, Mat3::eye()};
    for (int axis = 0; axis < 3; ++axis) {
        grid.direction(axis, 0) = row[axis];
        grid.direction(axis, 1) = column[axis];
        grid.direction(axis, 2) = normal[axis];
    }
    return grid;
}

Result<void> GroupLayout::findProbe() {
    UltrasoundFrame frame = readUltrasoundFrame(m_dataset);
    for (auto&& fact : frame.facts) m_layout.facts.push_back(std::move(fact));
    for (auto&& warning : frame.warnings) m_layout.warnings.push_back(std::move(warning));
    const auto grid = gridInVolumeFrame();
    if (!grid) return tl::unexpected(grid.error());
    if (*grid)
        m_layout.probe = probeOf(frame, **grid, m_layout.geometry, m_layout.warnings);
    else if (frame.apexMm || frame.transducerFromVolume)
        m_layout.warnings.emplace_back(
            "The place of the probe was left out: it is stated in the volume's frame of "
            "reference, where the frames have no place.");
    return {};
}

Result<FrameLayout> GroupLayout::layOut(std::int64_t columns, std::int64_t rows) {
    m_layout.geometry.size = {columns, rows, 1};
    if (auto taken = takePhases(); !taken) return tl::unexpected(taken.error());
    if (m_layout.phases.front().size() < 2) return m_layout;
    if (auto chosen = choosePlanes(); !chosen) return tl::unexpected(chosen.error());
    if (auto stacked = stackPhases(); !stacked) return tl::unexpected(stacked.error());
    if (auto found = findProbe(); !found) return tl::unexpected(found.error());
    return m_layout;
}

/// Lays frames out by the old attributes at top level, in the phases of `vectors` if there are any.
Result<FrameLayout> layOutStack(const ClassicPlaces& places, const std::string& path, const FrameExtent& extent,
                                const FrameVectors& vectors) {
    FrameLayout layout;
    layout.phases = vectors.phases;
    if (layout.phases.empty()) {
        layout.phases.emplace_back(extent.frames);
        std::iota(layout.phases[0].begin(), layout.phases[0].end(), std::size_t{0});
    }
    const std::size_t slices = layout.phases.front().size();
    const Vec3 normal = places.start.alongRow.cross(places.start.alongColumn);
    const auto planeAt = [&](double offset) {
        return SlicePlane{places.start.position + normal * offset, places.start.alongRow, places.start.alongColumn};
    };
    std::vector<SlicePlane> planes;
    if (!places.offsets.empty())
        for (const std::size_t frame : layout.phases.front()) planes.push_back(planeAt(places.offsets[frame]));
    const auto gaps = static_cast<double>(slices - 1);
    if (places.between) planes = {planeAt(0), planeAt(*places.between * gaps)};
    auto stack = stackSlices(path, places.name, planes);
    if (!stack) return tl::unexpected(stack.error());
    if (places.between) {
        const bool backwards = stack->order.front() > 0;
        stack->spacing /= gaps;
        stack->order.resize(slices);
        std::iota(stack->order.begin(), stack->order.end(), std::size_t{0});
        if (backwards) std::ranges::reverse(stack->order);
    }
    const std::vector<std::size_t> first = layout.phases.front();
    for (auto& frames : layout.phases) {
        std::vector<std::size_t> ordered;
        for (const std::size_t slice : stack->order) {
            const std::size_t frame = frames[slice];
            if (!places.offsets.empty() &&
                std::abs(places.offsets[frame] - places.offsets[first[slice]]) > 0.1 * stack->spacing)
                return fail(FailureKind::unreadable, path, places.name, "changes from phase to phase",
                            "Export one phase, or all on one grid.");
            ordered.push_back(frame);
        }
        frames = std::move(ordered);
    }
    layout.warnings = places.warnings;
    layout.warnings.insert(layout.warnings.end(), stack->warnings.begin(), stack->warnings.end());
    if (const auto other = places.otherBetween.value_or(0.0);
        other != 0.0 && std::abs(std::abs(other) - stack->spacing) > 0.01 * stack->spacing)
        layout.warnings.push_back(fmt::format(
            "(0018,0088) Spacing Between Slices is {:.4g} mm, but {} puts the slices {:.4g} mm apart; that was taken.",
            other, places.name, stack->spacing));
    layout.geometry.size = {extent.columns, extent.rows, static_cast<std::int64_t>(slices)};
    layout.geometry.origin = stack->origin;
    layout.geometry.direction = stack->direction;
    layout.geometry.patientFrameKnown = places.orientationInPatient;
    layout.geometry.spacing = {places.scale.spacing[0], places.scale.spacing[1], stack->spacing};
    const bool isScaleStated = places.scale.kind == PictureScale::Kind::stated;
    layout.geometry.spacingKnown = isScaleStated && !places.isBetweenGuess;
    layout.inPlaneSpacingKnown = isScaleStated && places.isBetweenGuess;
    if (!places.scale.warning.empty()) layout.warnings.push_back(places.scale.warning);
    const bool byPixelSpacing = places.scale.source == tagText(pixelSpacingTag);
    if (layout.geometry.spacingKnown)
        layout.spacingSource = places.scale.source + (byPixelSpacing ? " Pixel Spacing, " : ", ") + places.name;
    else if (layout.inPlaneSpacingKnown)
        layout.spacingSource = places.scale.source;
    takeVectors(vectors, layout);
    return layout;
}

bool isAnyPlaced(const std::vector<FrameGroups>& groups) {
    return std::ranges::any_of(groups, [](const FrameGroups& frame) {
        return frame.inVolume.position || frame.inVolume.orientation || frame.inPatient.position ||
               frame.inPatient.orientation;
    });
}

bool lieInOnePlane(const std::vector<FrameGroups>& groups) {
    return std::ranges::all_of(groups, [&](const FrameGroups& frame) {
        return frame.inVolume.position == groups.front().inVolume.position &&
               frame.inPatient.position == groups.front().inPatient.position;
    });
}

}  // namespace

void takeScale(const SliceScale& scale, FrameLayout& layout) {
    layout.geometry.spacing = scale.spacing;
    layout.geometry.spacingKnown = scale.spacingKnown;
    layout.spacingSource = scale.source;
    layout.inPlaneSpacingKnown = scale.inPlaneKnown && !scale.spacingKnown;
    layout.warnings.insert(layout.warnings.end(), scale.warnings.begin(), scale.warnings.end());
}

void takeVectors(const FrameVectors& vectors, FrameLayout& layout) {
    layout.warnings.insert(layout.warnings.end(), vectors.warnings.begin(), vectors.warnings.end());
    layout.phaseSource = vectors.source;
    if (vectors.times) takeTimes(*vectors.times, layout);
}

Result<FrameLayout> layOutFrames(DcmItem& dataset, const std::string& path, const FrameExtent& extent,
                                 const Progress& progress) {
    const auto groups = readFunctionalGroups(dataset, path, extent.frames, progress);
    if (!groups) return tl::unexpected(groups.error());
    if (isAnyPlaced(*groups)) {
        auto layout = GroupLayout(dataset, path, *groups).layOut(extent.columns, extent.rows);
        if (!layout || layout->phases.front().size() > 1) return layout;
        if (layout->phases.size() == 1)
            return fail(FailureKind::unreadable, path, "", "holds a single plane of tissue, not a volume",
                        "Export the whole volume.");
        return framesWithoutGeometry(path,
                                     fmt::format("is a 2D cine: its {} frames show {} over time", layout->phases.size(),
                                                 lieInOnePlane(*groups) ? "one plane" : "several planes"));
    }
    const auto vectors = readFrameVectors(dataset, path, extent.frames);
    if (!vectors) return tl::unexpected(vectors.error());
    const auto places = classicPlaces(dataset, path, extent.frames);
    if (!places) return tl::unexpected(places.error());
    if (*places) return layOutStack(**places, path, extent, *vectors);
    return framesWithoutGeometry(path, fmt::format("is a 2D cine of {} frames without volume geometry", extent.frames));
}

tl::unexpected<Failure> singlePicture(const std::string& path) {
    return fail(FailureKind::unreadable, path, "", "is a single 2D picture, not a volume",
                "Open the folder that holds all slices, or a multi-frame file.");
}

tl::unexpected<Failure> framesWithoutGeometry(const std::string& path, const std::string& problem) {
    auto refused =
        fail(FailureKind::unreadable, path, "", problem,
             "Add --frames-as-slices to take its pictures as slices; their distance stays unknown unless the "
             "file states it.");
    refused.value().framesCouldBeSlices = true;
    return refused;
}

}  // namespace echolucent
