#include "processing/sampling/gradient_levels.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "processing/parallel.h"
#include "processing/sampling/gradient_magnitude.h"

namespace echolucent {

std::optional<GradientLevels> gradientLevels(const Volume& filled, double largest, const Progress& progress) {
    if (!(largest > 0.0)) throw std::invalid_argument("gradientLevels: the largest gradient must be above 0");
    const VolumeGeometry& geometry = filled.geometry();
    const GradientMagnitude gradients(filled);
    GradientLevels levels{largest, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()))};
    const auto toByte = static_cast<float>(255.0 / largest);
    parallelFor(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        std::vector<float> row(static_cast<std::size_t>(geometry.size[0]));
        for (std::int64_t y = 0; y < geometry.size[1] && !progress.cancelled(); ++y) {
            gradients.row(y, z, row);
            std::ranges::transform(row, levels.bytes.begin() + geometry.offset(0, y, z), [&](float magnitude) {
                // NOLINTNEXTLINE(bugprone-incorrect-roundings): no gradient is below 0.
                return static_cast<std::uint8_t>(std::min(magnitude * toByte, 255.0f) + 0.5f);
            });
        }
    });
    if (progress.cancelled()) return std::nullopt;
    return levels;
}

}  // namespace echolucent
