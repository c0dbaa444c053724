// Which of the readings of the method a config follows.
#pragma once

#include <array>
#include <optional>

#include "processing/adaptive_otf.h"

namespace echolucent {

/// The reading whose parameters a config has, whatever its initial function is (that is not a matter of reading); none:
/// they were changed.
[[nodiscard]] inline std::optional<MethodReading> readingOf(const AdaptiveOtfConfig& config) {
    for (const MethodReading reading : {MethodReading::standard, MethodReading::settled, MethodReading::asPublished}) {
        AdaptiveOtfConfig known = configOf(reading);
        known.initial = config.initial;
        if (known == config) return reading;
    }
    return std::nullopt;
}

}  // namespace echolucent
