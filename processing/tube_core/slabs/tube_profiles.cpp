#include "processing/tube_core/slabs/tube_profiles.h"

#include <algorithm>
#include <cmath>

#include "processing/tube_core/slabs/profile_kernels.h"

namespace echolucent {

TubeProfiles::TubeProfiles(std::span<const int> slabs)
    : m_begin(slabs.size() + 1, 0), m_first(slabs.size(), 0), m_count(slabs.size(), 0), m_anyData(slabs.size(), 0) {
    for (std::size_t tube = 0; tube < slabs.size(); ++tube)
        m_begin[tube + 1] = m_begin[tube] + static_cast<std::size_t>(std::max(slabs[tube], 0));
    m_means.resize(m_begin.back());
    m_spreads.resize(m_begin.back());
}

template <typename CountOf, typename Write>
void TubeProfiles::setFrom(std::size_t tube, std::size_t slabs, int cellSize, const CountOf& countOf,
                           const Write& write) {
    const int least = (cellSize * cellSize + 1) / 2;
    const auto enough = [&](std::size_t k) { return static_cast<int>(countOf(k)) >= least; };
    std::size_t first = 0, end = slabs;
    while (first < slabs && !enough(first)) ++first;
    while (end > first && !enough(end - 1)) --end;
    m_anyData[tube] = end > first ? 1 : 0;
    for (std::size_t k = 0; k < slabs && m_anyData[tube] == 0; ++k) m_anyData[tube] = countOf(k) > 0 ? 1 : 0;
    m_first[tube] = static_cast<int>(first);
    m_count[tube] = static_cast<int>(end - first);
    float* const means = m_means.data() + m_begin[tube];
    float* const spreads = m_spreads.data() + m_begin[tube];
    write(first, end - first, means, spreads);
    for (std::size_t k = 1; k < end - first; ++k) {
        if (enough(first + k)) continue;
        means[k] = means[k - 1];
        spreads[k] = spreads[k - 1];
    }
}

void TubeProfiles::set(std::size_t tube, std::span<const SlabMoments> slabs, int cellSize) {
    const auto write = [&](std::size_t first, std::size_t count, float* means, float* spreads) {
        for (std::size_t k = 0; k < count; ++k) {
            const SlabMoments& slab = slabs[first + k];
            means[k] = static_cast<float>(slab.mean);
            spreads[k] = static_cast<float>(std::sqrt(slab.squaredDeviations / std::max(slab.count, 1u)));
        }
    };
    setFrom(
        tube, slabs.size(), cellSize, [&](std::size_t k) { return slabs[k].count; }, write);
}

void TubeProfiles::set(std::size_t tube, const SlabSums& slabs, int cellSize, double whiteLevel) {
    const auto write = [&](std::size_t first, std::size_t count, float* means, float* spreads) {
        momentsFromSums(std::span(slabs.counts).subspan(first, count), std::span(slabs.sums).subspan(first, count),
                        std::span(slabs.sumsOfSquares).subspan(first, count), whiteLevel, {means, count},
                        {spreads, count});
    };
    setFrom(
        tube, slabs.sums.size(), cellSize, [&](std::size_t k) { return slabs.counts[k]; }, write);
}

void TubeProfiles::set(std::size_t tube, const SlabMeans& slabs, int cellSize, double whiteLevel) {
    const float white = static_cast<float>(whiteLevel);
    const auto write = [&](std::size_t first, std::size_t count, float* means, float* spreads) {
        for (std::size_t k = 0; k < count; ++k) {
            means[k] = slabs.means[first + k] / white;
            spreads[k] =
                std::sqrt(slabs.squaredDeviations[first + k] / std::max(slabs.counts[first + k], 1.0f)) / white;
        }
    };
    setFrom(
        tube, slabs.means.size(), cellSize, [&](std::size_t k) { return slabs.counts[k]; }, write);
}

}  // namespace echolucent
