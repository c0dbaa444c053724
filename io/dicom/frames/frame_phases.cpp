#include "io/dicom/frames/frame_phases.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

const std::string indexValuesName = "(0020,9157) Dimension Index Values";
const std::string timeOffsetName = "(0020,930d) Temporal Position Time Offset";
const std::string tissueType = "TISSUE_INTENSITY";

DimensionMeaning meaningOf(DicomTag pointer) {
    constexpr std::array positions{positionVolumeTag, positionPatientTag, DicomTag{0x0020, 0x9057}};
    constexpr std::array times{
        timeOffsetTag,
        temporalIndexTag,
        DicomTag{0x0020, 0x0100},  // Temporal Position Identifier
        DicomTag{0x0018, 0x9074},  // Frame Acquisition Date Time
        DicomTag{0x0018, 0x9151},  // Frame Reference Date Time
        DicomTag{0x0018, 0x1060},  // Trigger Time
        DicomTag{0x0020, 0x9153},  // Nominal Cardiac Trigger Delay Time
        DicomTag{0x0020, 0x9252},  // Actual Cardiac Trigger Delay Time
        DicomTag{0x0020, 0x9241},  // Nominal Percentage of Cardiac Phase
        DicomTag{0x0020, 0x9245},  // Nominal Percentage of Respiratory Phase
        DicomTag{0x0020, 0x9255},  // Nominal Respiratory Trigger Delay Time
        DicomTag{0x0020, 0x9257},  // Actual Respiratory Trigger Delay Time
    };
    if (std::ranges::find(positions, pointer) != positions.end()) return DimensionMeaning::position;
    if (std::ranges::find(times, pointer) != times.end()) return DimensionMeaning::time;
    return pointer == dataTypeTag ? DimensionMeaning::dataType : DimensionMeaning::other;
}

/// A data type in words, with its term: "flow velocity (FLOW_VELOCITY)".
std::string typeInWords(const std::string& term) {
    if (term.empty()) return "a type that is not stated";
    const bool isTerm = std::ranges::all_of(
        term, [](char one) { return (one >= 'A' && one <= 'Z') || (one >= '0' && one <= '9') || one == '_'; });
    if (!isTerm) return quotedText(term);
    std::string words = lowerCase(term);
    std::ranges::replace(words, '_', ' ');
    return fmt::format("{} ({})", words.substr(0, 64), term.substr(0, 64));
}

/// A time of frames beside their time offset.
struct FrameTime {
    std::optional<double> FrameGroups::*member;
    const char* name;
};
constexpr std::array otherTimes{FrameTime{&FrameGroups::triggerDelay, "Trigger Delay Time"},
                                FrameTime{&FrameGroups::referenceTime, "(0018,9151) Frame Reference Date Time"},
                                FrameTime{&FrameGroups::acquisitionTime, "(0018,9074) Frame Acquisition Date Time"}};

/// The attribute that a time was read from, as the frame says.
std::string nameOf(const FrameTime& time, const FrameGroups& frame) {
    if (time.member != &FrameGroups::triggerDelay) return time.name;
    const bool cardiac = frame.delayTag == DicomTag{0x0020, 0x9153} || frame.delayTag == DicomTag{0x0020, 0x9252};
    const bool actual = frame.delayTag == DicomTag{0x0020, 0x9252} || frame.delayTag == DicomTag{0x0020, 0x9257};
    return fmt::format("{} {} {} {}", tagText(frame.delayTag), actual ? "Actual" : "Nominal",
                       cardiac ? "Cardiac" : "Respiratory", time.name);
}

/// Splits the frames of one object. Each function looks for one kind of contradiction.
class PhaseSplitter {
public:
    PhaseSplitter(const std::string& path, const std::vector<FrameDimension>& dimensions,
                  const std::vector<FrameGroups>& groups, const std::vector<std::size_t>& tissue)
        : m_path(path), m_dimensions(dimensions), m_groups(groups), m_tissue(tissue) {}

    Result<FramePhases> split();

private:
    using Key = std::vector<double>;
    using Groups = std::map<Key, std::vector<std::size_t>>;  ///< the frames of each phase
    Result<void> checkDimensions() const;
    Result<void> checkIndexValues() const;
    Result<void> checkDataTypes() const;
    Result<void> checkUnknownDimensions() const;
    Result<void> checkPhases(const FramePhases& result) const;
    Result<void> setTimes(FramePhases& result) const;
    [[nodiscard]] bool counts(DimensionMeaning meaning) const;
    [[nodiscard]] bool allLieApart() const;
    [[nodiscard]] std::optional<std::array<double, 3>> placeOf(std::size_t frame) const;
    [[nodiscard]] std::optional<DicomTimes> risingTimes(const FramePhases& result, const FrameTime& time) const;
    [[nodiscard]] std::optional<Groups> keyedBy(const FrameTime& time) const;
    [[nodiscard]] std::optional<Groups> rankedBy(const FrameTime& time) const;
    [[nodiscard]] Key indexKey(std::size_t frame) const;
    [[nodiscard]] tl::unexpected<Failure> refuse(const std::string& element, const std::string& problem) const {
        return fail(FailureKind::unreadable, m_path, element, problem, exportAgain);
    }
    template <typename Has>
    [[nodiscard]] bool allHave(const Has& has) const {
        return std::ranges::all_of(m_tissue, [&](std::size_t frame) { return has(m_groups[frame]); });
    }

    const std::string& m_path;
    const std::vector<FrameDimension>& m_dimensions;
    const std::vector<FrameGroups>& m_groups;
    const std::vector<std::size_t>& m_tissue;
};

bool PhaseSplitter::counts(DimensionMeaning meaning) const {
    return std::ranges::any_of(m_dimensions, [&](const FrameDimension& one) { return one.meaning == meaning; });
}

std::optional<std::array<double, 3>> PhaseSplitter::placeOf(std::size_t frame) const {
    const FrameGroups& groups = m_groups[frame];
    const auto& position = groups.inPatient.position ? groups.inPatient.position : groups.inVolume.position;
    if (!position) return std::nullopt;
    return std::array{(*position)[0], (*position)[1], (*position)[2]};
}

bool PhaseSplitter::allLieApart() const {
    std::set<std::array<double, 3>> places;
    for (const std::size_t frame : m_tissue) {
        const auto place = placeOf(frame);
        if (!place || !places.insert(*place).second) return false;
    }
    return true;
}

PhaseSplitter::Key PhaseSplitter::indexKey(std::size_t frame) const {
    Key key;
    for (std::size_t index = 0; index < m_dimensions.size(); ++index)
        if (m_dimensions[index].meaning == DimensionMeaning::time) key.push_back(m_groups[frame].indexValues[index]);
    return key;
}

Result<void> PhaseSplitter::checkIndexValues() const {
    for (std::size_t frame = 0; frame < m_groups.size(); ++frame) {
        const auto& values = m_groups[frame].indexValues;
        if (values.size() != m_dimensions.size())
            return refuse(indexValuesName, fmt::format("holds {} values for frame {}, where {} dimensions are declared",
                                                       values.size(), frame + 1, m_dimensions.size()));
        if (std::ranges::find(values, 0U) != values.end())
            return refuse(indexValuesName, fmt::format("holds 0 for frame {}, where counting begins at 1", frame + 1));
    }
    return {};
}

Result<void> PhaseSplitter::checkDataTypes() const {
    for (std::size_t index = 0; index < m_dimensions.size(); ++index) {
        if (m_dimensions[index].meaning != DimensionMeaning::dataType) continue;
        std::map<std::uint32_t, std::string> typeOf;
        std::map<std::string, std::uint32_t> indexOf;
        for (const FrameGroups& frame : m_groups) {
            const auto& type = typeOf.emplace(frame.indexValues[index], frame.dataType).first->second;
            if (type != frame.dataType)
                return refuse(indexValuesName, fmt::format("gives one index to {} and {}", typeInWords(type),
                                                           typeInWords(frame.dataType)));
            if (indexOf.emplace(frame.dataType, frame.indexValues[index]).first->second != frame.indexValues[index])
                return refuse(indexValuesName, "gives several indices to " + typeInWords(frame.dataType));
        }
    }
    return {};
}

Result<void> PhaseSplitter::checkUnknownDimensions() const {
    for (std::size_t index = 0; index < m_dimensions.size(); ++index) {
        if (m_dimensions[index].meaning != DimensionMeaning::other) continue;
        const auto first = m_groups[m_tissue.front()].indexValues[index];
        if (!allHave([&](const FrameGroups& frame) { return frame.indexValues[index] == first; }))
            return fail(FailureKind::unreadable, m_path, "(0020,9165) Dimension Index Pointer",
                        fmt::format("lets the frames differ in {}, which is not known to be time, place or data type",
                                    tagText(m_dimensions[index].pointer)),
                        "Export one volume of them.");
    }
    return {};
}

Result<void> PhaseSplitter::checkPhases(const FramePhases& result) const {
    const std::size_t slices = result.phases.front().size();
    for (const auto& frames : result.phases) {
        if (frames.size() != slices)
            return refuse("(5200,9230) Per-frame Functional Groups",
                          fmt::format("gives {} slices at one time and {} at another", slices, frames.size()));
        std::map<std::uint32_t, std::size_t> frameAt;
        for (const std::size_t frame : frames)
            if (const auto index = positionIndexOf(m_dimensions, m_groups[frame]))
                if (const auto [there, isNew] = frameAt.emplace(*index, frame); !isNew)
                    return refuse(indexValuesName, fmt::format("puts frames {} and {} at one place and time",
                                                               there->second + 1, frame + 1));
    }
    return {};
}

Result<void> PhaseSplitter::checkDimensions() const {
    if (m_dimensions.empty()) return {};
    if (auto checked = checkIndexValues(); !checked) return checked;
    if (auto checked = checkDataTypes(); !checked) return checked;
    return checkUnknownDimensions();
}

/// Sets the times of phases, if all frames state their time offset. Fails if a phase does not begin after the one
/// before has ended. Without offsets, the first other time that all frames state and that rises from phase to phase is
/// taken.
Result<void> PhaseSplitter::setTimes(FramePhases& result) const {
    if (result.phases.size() < 2) return {};
    if (!allHave([](const FrameGroups& frame) { return frame.timeOffset.has_value(); })) {
        for (const FrameTime& time : otherTimes)
            if (result.times = risingTimes(result, time); result.times) break;
        return {};
    }
    DicomTimes times{{}, timeOffsetName};
    double latest = 0.0;
    for (const auto& frames : result.phases) {
        const auto [first, last] =
            std::ranges::minmax(frames, {}, [&](std::size_t frame) { return *m_groups[frame].timeOffset; });
        const double start = *m_groups[first].timeOffset;
        if (!times.seconds.empty() && !(start > latest))
            return refuse(timeOffsetName,
                          fmt::format("puts phase {} at {:.6g} s, not after phase {}, against the order of {}",
                                      times.seconds.size() + 1, start, times.seconds.size(), result.source));
        times.seconds.push_back(start);
        latest = *m_groups[last].timeOffset;
    }
    result.times = std::move(times);
    return {};
}

/// The first time of each phase; no value unless all frames state it and it rises from phase to phase.
std::optional<DicomTimes> PhaseSplitter::risingTimes(const FramePhases& result, const FrameTime& time) const {
    if (!allHave([&](const FrameGroups& frame) { return (frame.*time.member).has_value(); })) return std::nullopt;
    DicomTimes times{{}, nameOf(time, m_groups[result.phases.front().front()])};
    for (const auto& frames : result.phases) {
        const std::size_t first =
            *std::ranges::min_element(frames, {}, [&](std::size_t frame) { return *(m_groups[frame].*time.member); });
        const double start = *(m_groups[first].*time.member);
        if (!times.seconds.empty() && !(start > times.seconds.back())) return std::nullopt;
        times.seconds.push_back(start);
    }
    return times;
}

/// Splits frames by a time that all frames of a phase share; no value unless all state it and it differs.
std::optional<PhaseSplitter::Groups> PhaseSplitter::keyedBy(const FrameTime& time) const {
    if (!allHave([&](const FrameGroups& frame) { return (frame.*time.member).has_value(); })) return std::nullopt;
    Groups phases;
    for (const std::size_t frame : m_tissue) phases[{*(m_groups[frame].*time.member)}].push_back(frame);
    if (phases.size() < 2) return std::nullopt;
    return phases;
}

/// Splits frames whose places repeat by times that are no times of phases: the earliest frame of each place belongs to
/// the first phase. No value unless all frames state the time, and no two frames of one place the same.
std::optional<PhaseSplitter::Groups> PhaseSplitter::rankedBy(const FrameTime& time) const {
    if (!allHave([&](const FrameGroups& frame) { return (frame.*time.member).has_value(); })) return std::nullopt;
    std::map<std::array<double, 3>, std::map<double, std::size_t>> places;
    for (const std::size_t frame : m_tissue) {
        const auto place = placeOf(frame);
        if (!place || !places[*place].emplace(*(m_groups[frame].*time.member), frame).second) return std::nullopt;
    }
    Groups phases;
    for (const auto& [place, frames] : places) {
        double rank = 0;
        for (const auto& [at, frame] : frames) phases[{rank++}].push_back(frame);
    }
    for (auto& [rank, frames] : phases) std::ranges::sort(frames);
    return phases;
}

Result<FramePhases> PhaseSplitter::split() {
    if (const auto checked = checkDimensions(); !checked) return tl::unexpected(checked.error());
    FramePhases result;
    Groups phases;
    if (counts(DimensionMeaning::time)) {
        result.source = indexValuesName;
        for (const std::size_t frame : m_tissue) phases[indexKey(frame)].push_back(frame);
    } else if (allHave([](const FrameGroups& frame) { return frame.timeOffset.has_value(); })) {
        result.source = timeOffsetName;
        for (const std::size_t frame : m_tissue) phases[{*m_groups[frame].timeOffset}].push_back(frame);
    } else if (allHave([](const FrameGroups& frame) { return frame.temporalIndex.has_value(); })) {
        result.source = tagText(temporalIndexTag) + " Temporal Position Index";
        for (const std::size_t frame : m_tissue)
            phases[{static_cast<double>(*m_groups[frame].temporalIndex)}].push_back(frame);
    } else if (!allLieApart()) {
        for (const FrameTime& time : otherTimes) {
            auto found = time.member == &FrameGroups::triggerDelay ? keyedBy(time) : rankedBy(time);
            if (!found) continue;
            phases = *std::move(found);
            result.source = nameOf(time, m_groups[m_tissue.front()]);
            if (phases.size() > 1)
                result.warnings.push_back(
                    fmt::format("Frames lie at each of {} places {} times: {} tells {} phases apart.",
                                m_tissue.size() / phases.size(), phases.size(), result.source, phases.size()));
            break;
        }
    }
    if (phases.empty()) phases[{}] = m_tissue;
    if (phases.size() > 1 && phases.size() == m_tissue.size() && allLieApart()) {
        phases = {{Key{}, m_tissue}};
        result.warnings.push_back(
            fmt::format("Each of the {} frames has a time and a place of its own ({}): they are taken as one volume.",
                        m_tissue.size(), result.source));
        result.source.clear();
    }
    for (auto& [key, frames] : phases) result.phases.push_back(std::move(frames));
    if (const auto checked = checkPhases(result); !checked) return tl::unexpected(checked.error());
    if (const auto timed = setTimes(result); !timed) return tl::unexpected(timed.error());
    return result;
}

}  // namespace

std::vector<FrameDimension> readFrameDimensions(DcmItem& dataset) {
    constexpr DicomTag dimensionsTag{0x0020, 0x9222}, pointerTag{0x0020, 0x9165};
    std::vector<FrameDimension> dimensions;
    dicomVisitItems(dataset, dimensionsTag, [&](DcmItem& item) {
        const DicomTag pointer = dicomPointer(item, pointerTag).value_or(DicomTag{});
        dimensions.push_back({pointer, meaningOf(pointer)});
        return true;
    });
    return dimensions;
}

Result<TissueFrames> tissueFramesOf(const std::string& path, const std::vector<FrameGroups>& groups) {
    TissueFrames tissue;
    std::map<std::string, std::size_t> framesOfType;
    for (const FrameGroups& frame : groups) ++framesOfType[frame.dataType];
    const bool isStated = framesOfType.size() > 1 || !framesOfType.contains("");
    const std::string wanted = isStated ? tissueType : "";
    for (std::size_t frame = 0; frame < groups.size(); ++frame)
        if (groups[frame].dataType == wanted) tissue.frames.push_back(frame);
    std::string others;
    for (const auto& [type, count] : framesOfType)
        if (type != wanted && others.size() < 1000)
            others += fmt::format("{}{} of {}", others.empty() ? "" : ", ", count, typeInWords(type));
    if (tissue.frames.empty())
        return fail(FailureKind::unreadable, path, tagText(dataTypeTag) + " Data Type",
                    fmt::format("names no frame of tissue: there are {}", others),
                    "Export the volume with its tissue.");
    if (isStated) tissue.story = typeInWords(tissueType) + (others.empty() ? "" : "; left out: " + others);
    if (!others.empty())
        tissue.warnings.push_back(fmt::format("{} of {} frames show {} and were read; left out were {}.",
                                              tissue.frames.size(), groups.size(), typeInWords(tissueType), others));
    return tissue;
}

Result<FramePhases> splitIntoPhases(const std::string& path, const std::vector<FrameDimension>& dimensions,
                                    const std::vector<FrameGroups>& groups, const std::vector<std::size_t>& tissue) {
    return PhaseSplitter(path, dimensions, groups, tissue).split();
}

std::optional<std::uint32_t> positionIndexOf(const std::vector<FrameDimension>& dimensions, const FrameGroups& groups) {
    for (std::size_t index = 0; index < dimensions.size(); ++index)
        if (dimensions[index].meaning == DimensionMeaning::position) return groups.indexValues[index];
    return std::nullopt;
}

}  // namespace echolucent
