#include "processing/tube_core/tube_profiles.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

TubeProfiles::TubeProfiles(std::size_t tubes, int longest)
    : m_stride(static_cast<std::size_t>(std::max(longest, 0))),
      m_means(tubes * m_stride),
      m_spreads(tubes * m_stride),
      m_first(tubes, 0),
      m_count(tubes, 0) {}

void TubeProfiles::set(std::size_t tube, std::span<const SlabMoments> slabs, int cellSize) {
    const auto least = static_cast<std::uint32_t>((cellSize * cellSize + 1) / 2);
    const auto enough = [least](const SlabMoments& slab) { return slab.count >= least; };
    const auto first = std::find_if(slabs.begin(), slabs.end(), enough);
    const auto last = std::find_if(slabs.rbegin(), slabs.rend(), enough).base();
    m_first[tube] = static_cast<int>(first - slabs.begin());
    m_count[tube] = static_cast<int>(std::max<std::ptrdiff_t>(0, last - first));
    float* mean = m_means.data() + tube * m_stride;
    float* spread = m_spreads.data() + tube * m_stride;
    for (auto slab = first; slab < last; ++slab, ++mean, ++spread) {
        if (enough(*slab)) {
            *mean = static_cast<float>(slab->mean);
            *spread = static_cast<float>(std::sqrt(slab->squaredDeviations / slab->count));
        } else {
            *mean = mean[-1];
            *spread = spread[-1];
        }
    }
}

}  // namespace echolucent
