// All tube cores of a view slab by slab. Detection by ratio looks at all of them before it judges one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/slabs/tube_slabs.h"

namespace echolucent {

/// Mean and spread of every slab of every tube core, tube after tube. A slab is one unit of the tube's length,
/// cellSize x cellSize samples. A tube begins at its first slab with at least half data and ends at the last one.
/// Between them, a slab with less data repeats the slab before.
class TubeProfiles {
public:
    /// `slabs` holds the largest number of slabs of each tube; memory is taken for these only.
    explicit TubeProfiles(std::span<const int> slabs);

    /// Takes one tube's slabs. Several threads may set different tubes.
    void set(std::size_t tube, std::span<const SlabMoments> slabs, int cellSize);
    /// Takes sums of stored values and of their squares. `whiteLevel` is the stored value of normalised intensity 1.
    void set(std::size_t tube, const SlabSums& slabs, int cellSize, double whiteLevel);
    /// Takes means of stored values. `whiteLevel` is the volume's white level times slabScale(), because the means are
    /// multiplied by slabScale() too.
    void set(std::size_t tube, const SlabMeans& slabs, int cellSize, double whiteLevel);

    [[nodiscard]] std::size_t tubes() const { return m_first.size(); }
    /// Index of the tube's first slab among its samples.
    [[nodiscard]] int firstSlab(std::size_t tube) const { return m_first[tube]; }
    /// Whether any sample of the tube has data.
    [[nodiscard]] bool anyData(std::size_t tube) const { return m_anyData[tube] != 0; }
    /// Mean normalised intensity of each slab from firstSlab() on; empty if no slab holds enough data.
    [[nodiscard]] std::span<const float> means(std::size_t tube) const { return part(m_means, tube); }
    /// Standard deviation of a slab's samples, normalised intensity; as long as means().
    [[nodiscard]] std::span<const float> spreads(std::size_t tube) const { return part(m_spreads, tube); }

private:
    /// countOf(k) gives the number of samples of slab k with data. write(first, count, means, spreads) writes means and
    /// spreads of `count` slabs from slab `first` on. Values of slabs with too little data are then overwritten.
    template <typename CountOf, typename Write>
    void setFrom(std::size_t tube, std::size_t slabs, int cellSize, const CountOf& countOf, const Write& write);
    [[nodiscard]] std::span<const float> part(const std::vector<float>& values, std::size_t tube) const {
        return {values.data() + m_begin[tube], static_cast<std::size_t>(m_count[tube])};
    }

    std::vector<std::size_t> m_begin;  ///< where each tube begins in m_means and m_spreads, and where the last one ends
    std::vector<float> m_means, m_spreads;
    std::vector<int> m_first, m_count;
    std::vector<std::uint8_t> m_anyData;
};

}  // namespace echolucent
