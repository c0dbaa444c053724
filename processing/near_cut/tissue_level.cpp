#include "processing/near_cut/tissue_level.h"

#include <hwy/contrib/sort/vqsort.h>

#include <numeric>

namespace echolucent {

std::optional<double> tissueLevel(std::vector<float> intensities) {
    if (intensities.empty()) return std::nullopt;
    // Whoever opens a volume waits for this sort. std::sort() takes ten times as long as a vectorised one.
    thread_local hwy::Sorter sort;
    sort(intensities.data(), intensities.size(), hwy::SortAscending());
    const auto count = static_cast<double>(intensities.size());
    const double total = std::accumulate(intensities.begin(), intensities.end(), 0.0);
    double below = 0.0, best = -1.0, level = total / count;
    for (std::size_t i = 0; i + 1 < intensities.size(); ++i) {
        below += static_cast<double>(intensities[i]);
        const auto dark = static_cast<double>(i + 1);
        const double bright = (total - below) / (count - dark), apart = bright - below / dark;
        // The variance between the classes, but for a constant factor.
        if (const double between = dark * (count - dark) * apart * apart; between > best) {
            best = between;
            level = bright;
        }
    }
    if (!(level > 0.0)) return std::nullopt;
    return level;
}

}  // namespace echolucent
