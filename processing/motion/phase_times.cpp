#include "processing/motion/phase_times.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace echolucent {

namespace {

constexpr double largestJitter = 1e-3;  ///< share of the mean by which even gaps may differ from it

bool rises(const std::vector<double>& seconds) {
    return std::adjacent_find(seconds.begin(), seconds.end(), [](double one, double next) { return !(next > one); }) ==
           seconds.end();
}

/// The shortest and the longest gap of two times or more.
std::pair<double, double> gapsOf(const std::vector<double>& starts) {
    std::pair<double, double> gaps{starts[1] - starts[0], starts[1] - starts[0]};
    for (std::size_t phase = 1; phase < starts.size(); ++phase) {
        const double gap = starts[phase] - starts[phase - 1];
        gaps = {std::min(gaps.first, gap), std::max(gaps.second, gap)};
    }
    return gaps;
}

}  // namespace

PhaseTimes PhaseTimes::every(double seconds) {
    if (!std::isfinite(seconds) || !(seconds > 0)) return {};
    return {.meanSeconds = seconds, .starts = {}};
}

PhaseTimes phaseTimesAt(const std::vector<double>& seconds) {
    const bool finite = std::all_of(seconds.begin(), seconds.end(), [](double time) { return std::isfinite(time); });
    if (seconds.size() < 2 || !finite || !rises(seconds)) return {};
    PhaseTimes times = PhaseTimes::every((seconds.back() - seconds.front()) / static_cast<double>(seconds.size() - 1));
    if (!times.meanSeconds) return {};
    const auto [least, most] = gapsOf(seconds);
    if (most - *times.meanSeconds <= largestJitter * *times.meanSeconds &&
        *times.meanSeconds - least <= largestJitter * *times.meanSeconds)
        return times;
    for (const double time : seconds) times.starts.push_back(time - seconds.front());
    return rises(times.starts) ? times : PhaseTimes{};
}

std::optional<double> secondsOfPhase(const PhaseTimes& times, int phase) {
    if (!times.meanSeconds || phase < 0) return std::nullopt;
    if (times.starts.empty()) return phase * *times.meanSeconds;
    const auto index = static_cast<std::size_t>(phase);
    return index < times.starts.size() ? std::optional(times.starts[index]) : std::nullopt;
}

std::optional<double> secondsBetween(const PhaseTimes& times, int from, int to) {
    const auto one = secondsOfPhase(times, from), other = secondsOfPhase(times, to);
    if (std::abs(from - to) != 1 || !one || !other) return times.meanSeconds;
    return std::abs(*other - *one);
}

std::optional<std::pair<double, double>> gapsOf(const PhaseTimes& times) {
    if (!times.meanSeconds) return std::nullopt;
    if (times.starts.size() < 2) return std::pair(*times.meanSeconds, *times.meanSeconds);
    return gapsOf(times.starts);
}

bool areTimesOf(const PhaseTimes& times, std::size_t phases) {
    if (!times.meanSeconds) return times.starts.empty();
    if (!std::isfinite(*times.meanSeconds) || !(*times.meanSeconds > 0)) return false;
    if (times.starts.empty()) return true;
    if (times.starts.size() != phases || phases < 2 || times.starts.front() != 0.0 || !rises(times.starts) ||
        !std::isfinite(times.starts.back()))
        return false;
    const double mean = times.starts.back() / static_cast<double>(phases - 1);
    return std::abs(mean - *times.meanSeconds) <= largestJitter * *times.meanSeconds;
}

}  // namespace echolucent
