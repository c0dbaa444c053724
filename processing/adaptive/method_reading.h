// The readings of the method that are reported side by side (docs/method.md, "Readings").
#pragma once

#include <optional>
#include <string_view>

#include "processing/adaptive/adaptive_otf_config.h"

namespace echolucent {

enum class MethodReading {
    asPublished,   ///< the paper's words taken literally, but with eq. 5 mended and with d_max 0.03, which it leaves
                   ///< open. It knows no quiet voxels: of these, I_L and I_H are read as by the other readings
    settled,       ///< the paper's open points settled by experiment (docs/experiments.md, "Three readings")
    firstVersion,  ///< the defaults of version 0.1: those of today with RampRule::aim 0
    standard,      ///< the program's defaults
};
/// "published", "settled", "0.1", "default".
[[nodiscard]] std::string_view nameOf(MethodReading reading);
[[nodiscard]] std::optional<MethodReading> methodReadingFromName(std::string_view name);
/// The config of a reading; `standard` is AdaptiveOtfConfig{}.
[[nodiscard]] AdaptiveOtfConfig configOf(MethodReading reading);
/// The reading that a config is; empty if it is none. Tube grid and initial function belong to no reading and may
/// differ.
[[nodiscard]] std::optional<MethodReading> readingOf(const AdaptiveOtfConfig& config);

}  // namespace echolucent
