// Reading rows of tube cores by the route that config and volume ask for.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/slabs/tube_profiles.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/slabs/tube_slabs.h"

namespace echolucent {

/// Where tubes lie on voxels of integers: exact sums. Else in single precision, many slabs at a time; in double, sample
/// by sample, where Precision::double64 asks for it or the volume is beyond what meanSlabs() takes. Keeps the last row;
/// one per thread.
class TubeReader {
public:
    TubeReader(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config, bool withVariance);

    [[nodiscard]] bool onVoxels() const { return m_onVoxels; }
    /// The samples along an axis, as read() wants them.
    [[nodiscard]] TubeSamples samplesOf(const TubeAxis& axis) const;
    /// Reads the tubes of one row of the grid.
    void read(std::span<const TubeSamples> tubes);
    /// The cells of tube t of the row.
    void cells(std::size_t t, CellStatistics& cells) const;
    /// The profile of tube t of the row, into the profile of `tube`.
    void profile(std::size_t t, TubeProfiles& profiles, std::size_t tube) const;

private:
    enum class Route { exactSums, singlePrecision, doublePrecision };

    const Volume& m_volume;
    const Viewpoint& m_view;
    const AdaptiveOtfConfig& m_config;
    bool m_withVariance;
    bool m_onVoxels;
    std::optional<std::uint32_t> m_storedLimit;
    Route m_route;
    std::vector<SlabSums> m_sums;
    std::vector<SlabMeans> m_means;
    std::vector<std::vector<SlabMoments>> m_moments;
    std::vector<double> m_values;
};

}  // namespace echolucent
