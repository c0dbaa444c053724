// The times of phases that the keys of a text header state.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/stored/stored_volume.h"
#include "processing/motion/phase_times.h"

namespace echolucent {

/// What a header says of the times of its phases.
struct StatedTimes {
    PhaseTimes times;     ///< unknown if what it says cannot be used
    std::string source;   ///< the keys that say it
    std::string warning;  ///< a sentence if it cannot be used; else empty
};

/// The times at which phases begin: `values` in units of `seconds`, one for each of `phases`. The warning of others
/// says what is wrong with those of `source`.
[[nodiscard]] StatedTimes timesAt(std::vector<double> values, double seconds, std::int64_t phases, std::string source);
/// No times, because what `source` says is none: "tells the phases apart by FlipAngle".
[[nodiscard]] StatedTimes noTimes(std::string source, std::string_view says);
/// What a step of `step` units between phases says. `unit` is the header's word for the unit, which may say nothing:
/// then seconds are assumed, but for a step of 1, which programs write that know no time. No value if the step is none.
[[nodiscard]] std::optional<StatedTimes> timesEvery(double step, std::string_view unit, const std::string& source);

/// The number of the frame that a key of a sequence is about: 12 of "Seq_Frame0012_Timestamp", whose `ending` is
/// "_Timestamp". No value for any other key.
[[nodiscard]] std::optional<std::int64_t> frameOfKey(std::string_view key, std::string_view ending);

/// The times of a sequence by its keys Seq_Frame0000_Timestamp and so on, in seconds (MetaImage, NRRD). No value if the
/// header has no such key.
[[nodiscard]] std::optional<StatedTimes> timesOfSequence(const std::map<std::string, std::string>& keys,
                                                         std::int64_t phases);

/// Sets the times of `stored`, and adds the warning.
void takeTimes(StatedTimes times, StoredVolume& stored);

}  // namespace echolucent
