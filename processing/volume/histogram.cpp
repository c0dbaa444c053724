#include "processing/volume/histogram.h"

#include <algorithm>

namespace echolucent {

IntensityHistogram intensityHistogram(const Volume& volume) {
    IntensityHistogram histogram;
    const double white = volume.whiteLevel();
    std::visit(
        [&](const auto& voxels) {
            const std::uint8_t* mask = volume.dataMaskOrNull();
            for (std::size_t i = 0; i < voxels.size(); ++i) {
                if (mask != nullptr && mask[i] == 0) continue;
                const double intensity = static_cast<double>(voxels[i]) / white;
                const double bounded = intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
                ++histogram.counts[std::min<std::size_t>(255, static_cast<std::size_t>(bounded * 256.0))];
                ++histogram.total;
            }
        },
        volume.voxels());
    return histogram;
}

}  // namespace echolucent
