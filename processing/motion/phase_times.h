// When the phases of a study were acquired, and how long each is shown.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace echolucent {

/// Times of phases, seconds from the first. The default: unknown.
struct PhaseTimes {
    /// The mean from one phase to the next, above 0 and finite; no value if the times are unknown.
    std::optional<double> meanSeconds{};
    /// The time of each phase, rising from 0. Empty if the phases are evenly apart, or if the times are unknown.
    std::vector<double> starts{};

    /// Phases that are `seconds` apart; unknown if that is not finite or not above 0.
    [[nodiscard]] static PhaseTimes every(double seconds);
    friend bool operator==(const PhaseTimes&, const PhaseTimes&) = default;
};

/// The times of phases that were acquired at `seconds`, counted from any moment. Gaps that differ from their mean by a
/// thousandth or less count as even. Unknown if there are fewer than two, or if they do not rise.
[[nodiscard]] PhaseTimes phaseTimesAt(const std::vector<double>& seconds);

/// The time of a phase, counted from 0: seconds from the first phase. No value if times are unknown or if the phase has
/// none.
[[nodiscard]] std::optional<double> secondsOfPhase(const PhaseTimes& times, int phase);
/// Seconds from one phase to another, whichever is earlier: their distance if they are neighbours, else the mean (after
/// the last phase follows the first). No value if times are unknown.
[[nodiscard]] std::optional<double> secondsBetween(const PhaseTimes& times, int from, int to);

/// The shortest and the longest time from one phase to the next, seconds. No value if times are unknown.
[[nodiscard]] std::optional<std::pair<double, double>> gapsOf(const PhaseTimes& times);
/// Whether the times can be those of `phases` phases: finite, rising from 0, and a mean that agrees.
[[nodiscard]] bool areTimesOf(const PhaseTimes& times, std::size_t phases);

}  // namespace echolucent
