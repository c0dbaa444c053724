// How bright tissue is in a volume.
#pragma once

#include <optional>
#include <vector>

namespace echolucent {

/// The mean of the brighter of the two classes into which a threshold splits intensities best (Otsu 1979). Nothing
/// where there are no intensities, or none above 0. No intensity is below 0.
[[nodiscard]] std::optional<double> tissueLevel(std::vector<float> intensities);

}  // namespace echolucent
