// A ramp between two percentiles of the intensities as an OTF designer (docs/designers/percentile.md).
#pragma once

#include <optional>

#include "processing/designers/designer_declarations.h"

namespace echolucent {

/// The ranges stand in parametersOf().
struct PercentileConfig {
    static constexpr DesignerWords words{"percentile", "Percentile ramp"};
    double clear = 60.0;   ///< opacity is 0 up to this percentile of the voxels with data, %
    double full = 95.0;    ///< opacity is full from this percentile on, %; if not above `clear`, the ramp is a step
    double opacity = 1.0;  ///< full opacity, per unit
    friend bool operator==(const PercentileConfig&, const PercentileConfig&) = default;
};
[[nodiscard]] const ParameterTable<PercentileConfig>& parametersOf(const PercentileConfig&);

/// A curve that is clear up to one percentile (percentileOf(), the nearest rank) of input.shown, full from the other
/// on, and straight between. Voxels without data do not count. If config.full is not above config.clear, the ramp is a
/// step. If it is, but both percentiles are one intensity that many voxels share, the voxels above this intensity alone
/// give the upper end. If there are none above, those below give the lower end. If all data have one value, or there
/// are none, the curve is x^2. The message tells each of these cases but the step.
[[nodiscard]] std::optional<Design> design(const PercentileConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
