#include "io/dicom/frames/frame_vectors.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "io/dicom/frames/dicom_study.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

constexpr DicomTag actualDurationTag{0x0018, 0x1242};
constexpr DicomTag gatedSequence{0x0054, 0x0062};

enum class VectorMeaning { slice, time, other };

struct FrameVector {
    DicomTag tag;
    const char* name;
    VectorMeaning meaning = VectorMeaning::other;
    const char* what = "";  ///< that the frames of a file may not differ in, with the remedy
    const char* remedy = "";
};

constexpr std::array frameVectors{
    FrameVector{
        {0x0054, 0x0010}, "Energy Window Vector", VectorMeaning::other, "energy windows", "Export one energy window."},
    FrameVector{{0x0054, 0x0020},
                "Detector Vector",
                VectorMeaning::other,
                "detectors",
                "These are pictures, not a volume: reconstruct it first, or export one detector."},
    FrameVector{{0x0054, 0x0050},
                "Rotation Vector",
                VectorMeaning::other,
                "rotations",
                "These are projections, not a volume: reconstruct it first."},
    FrameVector{
        {0x0054, 0x0060}, "R-R Interval Vector", VectorMeaning::other, "R-R intervals", "Export one R-R interval."},
    FrameVector{{0x0054, 0x0090},
                "Angular View Vector",
                VectorMeaning::other,
                "angular views",
                "These are projections, not a volume: reconstruct it first."},
    FrameVector{{0x0054, 0x0030}, "Phase Vector", VectorMeaning::time},
    FrameVector{{0x0054, 0x0070}, "Time Slot Vector", VectorMeaning::time},
    FrameVector{{0x0054, 0x0100}, "Time Slice Vector", VectorMeaning::time},
    FrameVector{{0x0054, 0x0080}, "Slice Vector", VectorMeaning::slice},
};

bool isConstant(const std::vector<double>& values) {
    return std::ranges::all_of(values, [&](double value) { return value == values.front(); });
}

/// By how much the numbers of slices rise from each to the next; 0 if not evenly, or by more than any program counts; 1
/// of a single slice.
double evenStep(const std::map<double, std::size_t>& slices) {
    constexpr double largestStep = 16;
    if (slices.size() < 2) return 1;
    const double step = std::next(slices.begin())->first - slices.begin()->first;
    if (step > largestStep) return 0;
    double expected = slices.begin()->first;
    for (const auto& [slice, frame] : slices) {
        if (slice != expected) return 0;
        expected += step;
    }
    return step;
}

/// Splits the frames of one file.
class VectorReader {
public:
    VectorReader(DcmItem& dataset, const std::string& path, std::size_t frames)
        : m_dataset(dataset),
          m_path(path),
          m_frames(frames),
          m_isPointerStated(!dicomText(dataset, incrementPointerTag).empty()) {}

    Result<FrameVectors> read();

private:
    using Key = std::vector<double>;
    [[nodiscard]] bool isNamed(DicomTag tag) const;
    Result<void> take(const FrameVector& vector);
    Result<void> split();
    void setTimes();
    [[nodiscard]] std::optional<DicomTimes> timesOfPhases() const;
    [[nodiscard]] tl::unexpected<Failure> refuse(DicomTag tag, const char* name, const std::string& problem,
                                                 const std::string& remedy) const {
        auto refused = fail(FailureKind::unreadable, m_path, fmt::format("{} {}", tagText(tag), name), problem, remedy);
        refused.value().framesCouldBeSlices = true;
        return refused;
    }

    DcmItem& m_dataset;
    const std::string& m_path;
    std::size_t m_frames;
    bool m_isPointerStated;
    bool m_any = false;
    std::vector<Key> m_times;      // of each frame: its numbers along the vectors of time; empty if none tells
    std::vector<DicomTag> m_tags;  // of these vectors
    std::vector<double> m_slices;  // of each frame; empty if no vector tells
    std::vector<Key> m_phaseKeys;
    FrameVectors m_found;
};

bool VectorReader::isNamed(DicomTag tag) const {
    return m_isPointerStated ? namesAsIncrement(m_dataset, tag) : dicomHas(m_dataset, tag);
}

/// Takes a vector that is named. One whose numbers are all the same orders nothing.
Result<void> VectorReader::take(const FrameVector& vector) {
    if (!isNamed(vector.tag)) return {};
    if (dicomText(m_dataset, vector.tag).empty()) {
        if (!m_isPointerStated) return {};
        m_found.warnings.push_back(fmt::format("{} Frame Increment Pointer names {} {}, which is not in the file.",
                                               tagText(incrementPointerTag), tagText(vector.tag), vector.name));
        return {};
    }
    auto values = dicomNumbers(m_dataset, vector.tag, m_frames);
    if (values.empty()) {
        const std::string problem = fmt::format("is not one number for each of {} frames", m_frames);
        if (m_isPointerStated) return refuse(vector.tag, vector.name, problem, exportAgain);
        m_found.warnings.push_back(
            fmt::format("{} {} {}; it was left out.", tagText(vector.tag), vector.name, problem));
        return {};
    }
    m_any = true;
    if (isConstant(values)) return {};
    switch (vector.meaning) {
        case VectorMeaning::slice: m_slices = std::move(values); return {};
        case VectorMeaning::time:
            m_times.resize(m_frames);
            for (std::size_t frame = 0; frame < m_frames; ++frame) m_times[frame].push_back(values[frame]);
            m_tags.push_back(vector.tag);
            m_found.source +=
                fmt::format("{}{} {}", m_found.source.empty() ? "" : ", ", tagText(vector.tag), vector.name);
            return {};
        case VectorMeaning::other: break;
    }
    const std::set<double> different(values.begin(), values.end());
    return refuse(vector.tag, vector.name, fmt::format("has frames of {} {}", different.size(), vector.what),
                  vector.remedy);
}

Result<void> VectorReader::split() {
    constexpr DicomTag sliceTag{0x0054, 0x0080};
    constexpr const char* sliceName = "Slice Vector";
    std::map<Key, std::map<double, std::size_t>> phases;
    for (std::size_t frame = 0; frame < m_frames; ++frame) {
        const auto [there, isNew] = phases[m_times.empty() ? Key() : m_times[frame]].emplace(m_slices[frame], frame);
        if (!isNew)
            return refuse(sliceTag, sliceName,
                          fmt::format("puts frames {} and {} at one place and time", there->second + 1, frame + 1),
                          exportAgain);
    }
    const auto& first = phases.begin()->second;
    const double step = evenStep(first);
    if (step == 0)
        return refuse(sliceTag, sliceName,
                      fmt::format("counts {} slices from {} to {}: some are missing", first.size(),
                                  first.begin()->first, first.rbegin()->first),
                      exportAgain);
    if (step != 1)
        m_found.warnings.push_back(fmt::format("{} {} counts slices in steps of {}; they were taken one after another.",
                                               tagText(sliceTag), sliceName, step));
    for (const auto& [key, slices] : phases) {
        const auto samePlace = [](const auto& one, const auto& other) { return one.first == other.first; };
        if (!std::ranges::equal(slices, first, samePlace))
            return refuse(sliceTag, sliceName,
                          fmt::format("gives phase {} other slices than the first", m_phaseKeys.size() + 1),
                          exportAgain);
        m_phaseKeys.push_back(key);
        m_found.phases.emplace_back();
        for (const auto& [slice, frame] : slices) m_found.phases.back().push_back(frame);
    }
    return {};
}

/// The times that Phase Information states: each phase of an acquisition has its delay and the time from one of its
/// frames to the next.
std::optional<DicomTimes> VectorReader::timesOfPhases() const {
    constexpr DicomTag phaseTag{0x0054, 0x0030}, phaseSequence{0x0054, 0x0032};
    constexpr DicomTag delayTag{0x0054, 0x0036}, pauseTag{0x0054, 0x0038};
    struct PhaseSteps {
        double delay = 0, step = 0;  // seconds
    };
    std::vector<PhaseSteps> steps;
    dicomVisitItems(m_dataset, phaseSequence, [&](DcmItem& item) {
        const auto seconds = [&](DicomTag tag) { return dicomNumber(item, tag).value_or(0.0) / 1000; };
        steps.push_back({seconds(delayTag), seconds(actualDurationTag) + seconds(pauseTag)});
        return steps.size() <= m_frames;
    });
    const bool byPhase = !m_tags.empty() && m_tags.front() == phaseTag;
    DicomTimes times{{}, "(0054,0032) Phase Information"};
    double now = 0;
    std::size_t before = 0;  // the phase of the volume before, counted from 1
    for (const Key& key : m_phaseKeys) {
        const double number = byPhase ? key.front() : 1;
        if (!(number >= 1) || number > static_cast<double>(steps.size())) return std::nullopt;
        const auto phase = static_cast<std::size_t>(number);
        if (phase != before) now += steps[phase - 1].delay;
        before = phase;
        if (!times.seconds.empty() && !(now > times.seconds.back())) return std::nullopt;
        times.seconds.push_back(now);
        now += steps[phase - 1].step;
    }
    const double begin = times.seconds.front();
    for (double& time : times.seconds) time -= begin;
    return times;
}

void VectorReader::setTimes() {
    constexpr DicomTag dataSequence{0x0054, 0x0063};
    const std::size_t count = m_found.phases.size();
    if (count < 2) return;
    DcmItem* const gated = dicomFirstItem(m_dataset, gatedSequence);
    DcmItem* const data = gated != nullptr ? dicomFirstItem(*gated, dataSequence) : nullptr;
    if (data != nullptr) m_found.times = statedFrameTimes(*data, count);
    if (!m_found.times) m_found.times = timesOfPhases();
    if (!m_found.times) m_found.times = statedFrameTimes(m_dataset, count);
    // Of a gated study this is the time of the whole acquisition.
    const auto duration = gated == nullptr ? dicomNumber(m_dataset, actualDurationTag) : std::nullopt;
    if (m_found.times || !(duration.value_or(0.0) > 0)) return;
    m_found.times = evenTimes(*duration / 1000, count, tagText(actualDurationTag) + " Actual Frame Duration");
}

Result<FrameVectors> VectorReader::read() {
    for (const FrameVector& vector : frameVectors)
        if (auto taken = take(vector); !taken) return tl::unexpected(taken.error());
    if (!m_any || (m_slices.empty() && m_tags.empty())) return std::move(m_found);
    if (m_slices.empty())
        return framesWithoutGeometry(
            m_path, fmt::format("is a 2D cine: its {} frames show one plane over time ({})", m_frames, m_found.source));
    if (auto done = split(); !done) return tl::unexpected(done.error());
    if (m_found.phases.size() > 1)
        m_found.warnings.push_back(fmt::format("Frames lie at each of {} places {} times: {} {} {} phases apart.",
                                               m_found.phases.front().size(), m_found.phases.size(), m_found.source,
                                               m_tags.size() > 1 ? "tell" : "tells", m_found.phases.size()));
    setTimes();
    return std::move(m_found);
}

}  // namespace

std::vector<DicomTag> frameVectorTags() {
    std::vector<DicomTag> tags;
    std::ranges::transform(frameVectors, std::back_inserter(tags), &FrameVector::tag);
    return tags;
}

Result<FrameVectors> readFrameVectors(DcmItem& dataset, const std::string& path, std::size_t frames) {
    return VectorReader(dataset, path, frames).read();
}

}  // namespace echolucent
