// Otsu's threshold (1979) as an OTF designer: a ramp about the intensity that splits the voxels into a dark and a
// bright class (docs/designers/otsu.md).
#pragma once

#include <optional>

#include "processing/designers/designer_declarations.h"

namespace echolucent {

struct IntensityCounts;

/// The ranges stand in parametersOf().
struct OtsuConfig {
    static constexpr DesignerWords words{"otsu", "Otsu ramp"};
    double spreads = 1.0;  ///< the ramp reaches this many class spreads to either side of the threshold
    double opacity = 1.0;  ///< of the bright class beyond the ramp, per unit
    friend bool operator==(const OtsuConfig&, const OtsuConfig&) = default;
};
[[nodiscard]] const ParameterTable<OtsuConfig>& parametersOf(const OtsuConfig&);

/// A curve that is clear below the ramp and has config.opacity beyond it. The ramp is straight from the threshold minus
/// config.spreads times the dark class's spread to the threshold plus as many times the bright class's, both within
/// [0,1]. The designer reads input.shown; voxels without data do not count. If all data have one value, or there are
/// none, the curve is x^2, and the message says so.
[[nodiscard]] std::optional<Design> design(const OtsuConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// The voxels on one side of a threshold.
struct IntensityClass {
    double share = 0.0;   ///< of the voxels with data, (0,1)
    double mean = 0.0;    ///< normalised intensity
    double spread = 0.0;  ///< standard deviation, normalised intensity
    friend bool operator==(const IntensityClass&, const IntensityClass&) = default;
};

/// The split into the two classes with the largest variance between them.
struct OtsuClasses {
    double threshold = 0.0;  ///< half way between the largest intensity of `dark` and the smallest of `bright`
    IntensityClass dark{}, bright{};
    /// The largest of any threshold: product of the shares times the square of the difference of the means.
    double betweenVariance = 0.0;
    friend bool operator==(const OtsuClasses&, const OtsuClasses&) = default;
};

/// Empty for fewer than two intensities. Of equally good thresholds the lowest counts.
[[nodiscard]] std::optional<OtsuClasses> otsuClasses(const IntensityCounts& counts);

}  // namespace echolucent
