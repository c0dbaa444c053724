// The readings of the method that are reported side by side (docs/method.md, "Readings").
#pragma once

#include <optional>
#include <string_view>

#include "processing/adaptive/adaptive_otf_config.h"

namespace echolucent {

enum class MethodReading {
    asPublished,  ///< the paper's words taken literally, with the erratum of eq. 5 and d_max 0.03
    settled,      ///< the paper's open points settled by experiment (docs/experiments.md, "Three readings")
    standard,     ///< what the program uses where nobody asks for another
};
/// "published", "settled", "default".
[[nodiscard]] std::string_view nameOf(MethodReading reading);
[[nodiscard]] std::optional<MethodReading> methodReadingFromName(std::string_view name);
/// The config of a reading; `standard` is AdaptiveOtfConfig{}.
[[nodiscard]] AdaptiveOtfConfig configOf(MethodReading reading);
/// The reading that a config is, whatever its tube grid and initial function, which belong to no reading. Nothing
/// where the config is no reading.
[[nodiscard]] std::optional<MethodReading> readingOf(const AdaptiveOtfConfig& config);

}  // namespace echolucent
