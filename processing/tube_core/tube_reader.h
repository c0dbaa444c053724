// Reads rows of tube cores in the way that suits rule and volume.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/tube_core/rules/cell_rule.h"
#include "processing/tube_core/slabs/tube_profiles.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/slabs/tube_slabs.h"

namespace echolucent {

/// Reads exact sums if the tubes lie on voxels and exactStoredLimit() has a value, whatever the rule's precision. Else
/// it reads in single precision, many slabs at a time; or in double, sample by sample, if Precision::double64 asks for
/// it or canMeanSlabs() is false. A reader keeps the row that it read last, so each thread needs its own reader.
class TubeReader {
public:
    /// The volume must outlive the reader.
    TubeReader(const Volume& volume, const CellRule& rule);

    /// Reads the tubes of one row of the grid, as samplesOf() gives them.
    void read(std::span<const TubeSamples> tubes);
    /// Hands over the slabs of the tube at this place of the row. Ask once for each place, and not for its profile
    /// afterwards.
    [[nodiscard]] TubeSlabs slabsAt(std::size_t place);
    /// Writes the profile of the tube at this place of the row as the profile of `tube`.
    void profile(std::size_t place, TubeProfiles& profiles, std::size_t tube) const;

private:
    enum class Route { exactSums, singlePrecision, doublePrecision };
    [[nodiscard]] double whiteLevel() const;

    const Volume& m_volume;
    CellRule m_rule;
    std::optional<std::uint32_t> m_storedLimit;
    Route m_interpolating;  ///< the route of tubes that do not lie on voxels
    Route m_route;          ///< of the last row
    std::vector<SlabSums> m_sums;
    std::vector<SlabMeans> m_means;
    std::vector<std::vector<SlabMoments>> m_moments;
    std::vector<double> m_values;
};

}  // namespace echolucent
