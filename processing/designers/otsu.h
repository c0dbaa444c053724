// Otsu's threshold (1979) as an OTF designer: a ramp about the intensity that splits the voxels into a dark and a
// bright class (docs/designers/otsu.md).
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/otsu_config.h"
#include "processing/intensity/intensity_counts.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

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

/// Its table; the argument only selects it.
[[nodiscard]] const ParameterTable<OtsuConfig>& parametersOf(const OtsuConfig&);

/// A curve that is clear below the ramp. The ramp is straight from the threshold minus the dark class's spread to the
/// threshold plus the bright class's, both within [0,1]. It reads input.shown; voxels without data do not count. If all
/// data have one value, or there are none, the curve is x^2, and the message says so. The result is empty only if
/// progress.cancel was raised. Its bits are the same for any number of threads. Throws std::invalid_argument if a
/// parameter is out of its range or the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const OtsuConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
