// Profiles of tube cores, made slab by slab, so that tests know each mean and spread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "processing/tube_core/slabs/tube_profiles.h"

namespace echolucent {

/// What one tube core must see: as many means as spreads, in normalised intensity.
struct MadeProfile {
    std::vector<double> means, spreads;
};

inline constexpr int madeCellSize = 5;

/// The profiles of such tube cores, with every slab full of data.
inline TubeProfiles profilesOf(const std::vector<MadeProfile>& made) {
    std::vector<int> lengths;
    for (const MadeProfile& profile : made) lengths.push_back(static_cast<int>(profile.means.size()));
    TubeProfiles profiles(lengths);
    std::vector<SlabMoments> slabs;
    for (std::size_t t = 0; t < made.size(); ++t) {
        slabs.clear();
        constexpr std::uint32_t count = madeCellSize * madeCellSize;
        for (std::size_t k = 0; k < made[t].means.size(); ++k)
            slabs.push_back({count, made[t].means[k], count * made[t].spreads[k] * made[t].spreads[k]});
        profiles.set(t, slabs, madeCellSize);
    }
    return profiles;
}

/// Slabs of multiplicative speckle around true levels.
class SpeckledSlabs {
public:
    /// `spread` is that of voxels, `spreadOfMeans` that of a slab's mean, both as a share of the mean.
    SpeckledSlabs(std::uint32_t seed, double spread = 0.25, double spreadOfMeans = 0.08)
        : m_random(seed), m_spread(spread), m_spreadOfMeans(spreadOfMeans) {}

    MadeProfile around(const std::vector<double>& levels) {
        MadeProfile made;
        for (const double level : levels) {
            const double mean = level * std::max(0.05, 1.0 + m_spreadOfMeans * m_normal(m_random));
            made.means.push_back(mean);
            // The spread of 25 samples is itself uncertain by a seventh.
            made.spreads.push_back(m_spread * level * std::exp(0.14 * m_normal(m_random)));
        }
        return made;
    }
    /// A whole number from least to most.
    int drawn(int least, int most) { return std::uniform_int_distribution<int>(least, most)(m_random); }
    double drawn(double least, double most) { return std::uniform_real_distribution<double>(least, most)(m_random); }

private:
    std::mt19937 m_random;
    std::normal_distribution<double> m_normal{0.0, 1.0};
    double m_spread, m_spreadOfMeans;
};

}  // namespace echolucent
