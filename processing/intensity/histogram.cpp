#include "processing/intensity/histogram.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "processing/intensity/intensity_counts.h"

namespace echolucent {

namespace {

void count(double intensity, std::uint64_t times, IntensityHistogram& histogram) {
    const double bounded = intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
    histogram.counts[std::min<std::size_t>(255, static_cast<std::size_t>(bounded * 256.0))] += times;
    histogram.total += times;
}

}  // namespace

IntensityHistogram intensityHistogram(const Volume& volume) {
    IntensityHistogram histogram;
    const double white = volume.whiteLevel();
    const std::uint8_t* mask = volume.dataMaskOrNull();
    std::visit(
        [&]<typename Value>(const VoxelArray<Value>& voxels) {
            if constexpr (std::is_integral_v<Value>) {
                const IntensityCounts counts = intensityCounts(volume);
                for (std::size_t i = 0; i < counts.counts.size(); ++i)
                    count(counts.intensities[i], counts.counts[i], histogram);
            } else {
                for (std::size_t i = 0; i < voxels.size(); ++i)
                    if (mask == nullptr || mask[i] != 0) count(static_cast<double>(voxels[i]) / white, 1, histogram);
            }
        },
        volume.voxels());
    return histogram;
}

}  // namespace echolucent
