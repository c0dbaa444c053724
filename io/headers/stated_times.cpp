#include "io/headers/stated_times.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/headers/header_units.h"

namespace echolucent {

StatedTimes timesAt(std::vector<double> values, double seconds, std::int64_t phases, std::string source) {
    if (static_cast<std::int64_t>(values.size()) != phases)
        return noTimes(std::move(source), fmt::format("gives {} times for {} phases", values.size(), phases));
    for (double& value : values) value *= seconds;
    StatedTimes stated{.times = phaseTimesAt(values), .source = std::move(source), .warning = {}};
    if (!stated.times.meanSeconds) return noTimes(std::move(stated.source), "gives times that do not rise");
    return stated;
}

StatedTimes noTimes(std::string source, std::string_view says) {
    std::string warning = fmt::format("{} {}: the time between phases is unknown.", source, says);
    return {.times = {}, .source = std::move(source), .warning = std::move(warning)};
}

std::optional<StatedTimes> timesEvery(double step, std::string_view unit, const std::string& source) {
    if (!std::isfinite(step) || step <= 0) return std::nullopt;
    if (saysNoUnit(unit)) {
        if (step == 1.0) return std::nullopt;
        return StatedTimes{PhaseTimes::every(step), source + ", assumed to be seconds", {}};
    }
    const auto seconds = secondsOfUnit(unit);
    if (!seconds) return noTimes(source, fmt::format("is in {}, which is not a known time", quotedText(unit)));
    return StatedTimes{PhaseTimes::every(step * *seconds), source + ", units", {}};
}

std::optional<std::int64_t> frameOfKey(std::string_view key, std::string_view ending) {
    constexpr std::string_view beginning = "Seq_Frame";
    if (!key.starts_with(beginning) || !key.ends_with(ending) || key.size() <= beginning.size() + ending.size())
        return std::nullopt;
    return wholeNumber(key.substr(beginning.size(), key.size() - beginning.size() - ending.size()));
}

std::optional<StatedTimes> timesOfSequence(const std::map<std::string, std::string>& keys, std::int64_t phases) {
    std::map<std::int64_t, double> times;
    std::string first;
    for (const auto& [key, text] : keys) {
        const auto number = frameOfKey(key, "_Timestamp");
        if (!number) continue;
        if (first.empty()) first = quotedText(key);
        const auto points = withDecimalPoints(text);
        times[*number] = realNumber(points ? *points : text).value_or(std::numeric_limits<double>::quiet_NaN());
    }
    if (times.empty()) return std::nullopt;
    std::vector<double> values;
    for (const auto& [number, time] : times) values.push_back(time);
    return timesAt(std::move(values), 1.0, phases, first + " and the others");
}

void takeTimes(StatedTimes times, StoredVolume& stored) {
    stored.phaseTimes = std::move(times.times);
    stored.phaseSource = std::move(times.source);
    if (!times.warning.empty()) stored.warnings.push_back(std::move(times.warning));
}

}  // namespace echolucent
