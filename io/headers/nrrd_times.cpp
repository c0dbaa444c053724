#include "io/headers/nrrd_times.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/headers/header_units.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

class NrrdTimes {
public:
    NrrdTimes(const NrrdFields& fields, const NrrdAxes& axes, std::size_t timeAxis)
        : m_fields(fields), m_axes(axes), m_timeAxis(timeAxis), m_phases(axes.sizes[timeAxis]) {}
    [[nodiscard]] std::optional<StatedTimes> ofSequence() const;
    [[nodiscard]] std::optional<StatedTimes> ofMultiVolume() const;
    [[nodiscard]] std::optional<StatedTimes> ofDirection() const;

private:
    [[nodiscard]] std::string keyOf(const std::string& key) const {
        const auto found = m_fields.keys.find(key);
        return found == m_fields.keys.end() ? std::string() : found->second;
    }
    /// The word of a field for each axis that belongs to the axis of time.
    [[nodiscard]] std::string wordOfTimeAxis(const std::string& field) const {
        const auto found = m_fields.fields.find(field);
        const auto words = found == m_fields.fields.end() ? std::vector<std::string>{} : nrrdWords(found->second);
        return m_timeAxis < words.size() ? words[m_timeAxis] : std::string();
    }

    const NrrdFields& m_fields;
    const NrrdAxes& m_axes;
    std::size_t m_timeAxis;
    std::int64_t m_phases;
};

bool countsByOne(const std::vector<double>& values) {
    return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return b - a != 1.0; }) ==
           values.end();
}

std::optional<std::vector<double>> numbersIn(std::string text) {
    std::replace(text.begin(), text.end(), '"', ' ');
    if (const auto points = withDecimalPoints(text)) text = *points;
    return realNumbers(text);
}

/// Slicer's sequences: "axis 3 index values:=0 0.04 0.08", with the name of the index among the labels.
std::optional<StatedTimes> NrrdTimes::ofSequence() const {
    std::string axis = fmt::format("axis {} index ", m_timeAxis);
    // Programs that move the axis of time to another place keep the keys.
    for (std::size_t other = 0; other < m_axes.sizes.size() && keyOf(axis + "values").empty(); ++other)
        axis = fmt::format("axis {} index ", other);
    const std::string source = axis + "values", text = keyOf(source);
    if (text.empty()) return std::nullopt;
    const std::string type = lowerCase(keyOf(axis + "type"));
    const auto values = numbersIn(text);
    if ((!type.empty() && type != "numeric") || !values) return noTimes(source, "are texts, which are no times");
    const std::string unit = unitOfAxis(m_fields, m_axes, m_timeAxis);
    const std::string label = wordOfTimeAxis("labels");
    const bool isTime = lowerCase(label).find("time") != std::string::npos;
    if (!saysNoUnit(unit)) {
        const auto seconds = secondsOfUnit(unit);
        if (!seconds) return noTimes(source, fmt::format("are in {}, which is not a known time", quotedText(unit)));
        return timesAt(*values, *seconds, m_phases, source + ", units");
    }
    if (!label.empty() && !isTime)
        return noTimes(source, fmt::format("are called {}, which is no time", quotedText(label)));
    // Without a unit and a name, these are as well the numbers of frames.
    if (!isTime && countsByOne(*values)) return std::nullopt;
    return timesAt(*values, 1.0, m_phases, source + ", assumed to be seconds");
}

/// Slicer's MultiVolume: the values of a DICOM attribute, of which some are times of acquisition.
std::optional<StatedTimes> NrrdTimes::ofMultiVolume() const {
    const std::string source = "MultiVolume.FrameLabels";
    std::string labels = keyOf(source);
    const std::string tag = keyOf("MultiVolume.FrameIdentifyingDICOMTagName");
    const std::string unit = keyOf("MultiVolume.FrameIdentifyingDICOMTagUnits");
    if (labels.empty() || (tag.empty() && saysNoUnit(unit))) return std::nullopt;
    const std::string name = lowerCase(tag);
    const auto holds = [&](std::string_view word) { return name.find(word) != std::string::npos; };
    // These times belong to how one picture is made.
    const bool isOther = holds("echo") || holds("repetition") || holds("inversion") || holds("exposure");
    if (!tag.empty() && (isOther || !holds("time")))
        return noTimes(source,
                       fmt::format("tells the phases apart by {}, which is no time of theirs", quotedText(tag)));
    std::replace(labels.begin(), labels.end(), ',', ' ');
    const auto values = realNumbers(labels);
    if (!values) return noTimes(source, "is no list of numbers");
    // DICOM counts these in ms.
    const bool inMs = saysNoUnit(unit) && (name == "triggertime" || name == "frametime");
    const auto seconds = inMs ? std::optional(1e-3) : secondsOfUnit(unit);
    if (!seconds && saysNoUnit(unit)) return noTimes(source, "has no unit");
    if (!seconds) return noTimes(source, fmt::format("is in {}, which is not a known time", quotedText(unit)));
    return timesAt(*values, *seconds, m_phases,
                   source + (inMs ? ", in ms by DICOM" : ", MultiVolume.FrameIdentifyingDICOMTagUnits"));
}

/// A fourth direction, which leads through time alone.
std::optional<StatedTimes> NrrdTimes::ofDirection() const {
    if (m_axes.directions.empty() || !isTimeDirection(m_axes.directions[m_timeAxis])) return std::nullopt;
    const double step = (*m_axes.directions[m_timeAxis])[3];
    if (step < 0) return noTimes("space directions", "leads back in time");
    const auto units = m_fields.fields.find("space units");
    const auto words = units == m_fields.fields.end() ? std::vector<std::string>{} : nrrdWords(units->second);
    return timesEvery(step, words.size() > 3 ? words[3] : unitOfAxis(m_fields, m_axes, m_timeAxis), "space directions");
}

}  // namespace

std::optional<StatedTimes> nrrdTimes(const NrrdFields& fields, const NrrdAxes& axes, const NrrdSpacings& spacings,
                                     std::size_t timeAxis) {
    if (axes.sizes[timeAxis] < 2) return std::nullopt;
    const NrrdTimes times(fields, axes, timeAxis);
    if (auto stated = times.ofSequence()) return stated;
    if (auto stated = times.ofMultiVolume()) return stated;
    if (auto stated = timesOfSequence(fields.keys, axes.sizes[timeAxis])) return stated;
    if (auto stated = times.ofDirection()) return stated;
    if (spacings.values.empty()) return std::nullopt;
    return timesEvery(spacings.values[timeAxis], unitOfAxis(fields, axes, timeAxis), spacings.source);
}

}  // namespace echolucent
