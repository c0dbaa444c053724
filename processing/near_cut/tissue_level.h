// How bright tissue is in a volume.
#pragma once

#include <optional>
#include <vector>

namespace echolucent {

/// The mean of the brighter of the two classes into which a threshold splits intensities best (Otsu 1979). Empty if
/// there are no intensities, or none above 0. `intensities` must hold nothing below 0 and no NaN.
[[nodiscard]] std::optional<double> tissueLevel(std::vector<float> intensities);

}  // namespace echolucent
