#include "processing/tube_core/tube_reader.h"

namespace echolucent {

TubeReader::TubeReader(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config, bool withVariance)
    : m_volume(volume),
      m_view(view),
      m_config(config),
      m_withVariance(withVariance),
      m_onVoxels(tubesLieOnVoxels(volume.geometry(), view)),
      m_storedLimit(m_onVoxels ? exactStoredLimit(volume) : std::nullopt),
      m_route(m_storedLimit                                                     ? Route::exactSums
              : config.precision == Precision::single32 && canMeanSlabs(volume) ? Route::singlePrecision
                                                                                : Route::doublePrecision) {}

TubeSamples TubeReader::samplesOf(const TubeAxis& axis) const {
    return echolucent::samplesOf(axis, m_volume.geometry(), m_view, m_config.cellSize, m_onVoxels);
}

void TubeReader::read(std::span<const TubeSamples> tubes) {
    switch (m_route) {
        case Route::exactSums:
            m_sums.resize(tubes.size());
            sumSlabs(m_volume, *m_storedLimit, tubes, m_withVariance, m_sums);
            break;
        case Route::singlePrecision:
            m_means.resize(tubes.size());
            meanSlabs(m_volume, m_config.sampling, tubes, m_withVariance, m_means);
            break;
        case Route::doublePrecision:
            m_moments.resize(tubes.size());
            for (std::size_t t = 0; t < tubes.size(); ++t)
                sampleSlabs(m_volume, m_config.sampling, tubes[t], m_moments[t], m_values);
            break;
    }
}

void TubeReader::cells(std::size_t t, CellStatistics& cells) const {
    const double white = m_volume.whiteLevel();
    switch (m_route) {
        case Route::exactSums: return cellsFrom(m_sums[t], m_config.cellSize, white, cells);
        case Route::singlePrecision:
            return cellsFrom(m_means[t], m_config.cellSize, white * slabScale(m_volume), cells);
        case Route::doublePrecision: return cellsFrom(m_moments[t], m_config.cellSize, cells);
    }
}

void TubeReader::profile(std::size_t t, TubeProfiles& profiles, std::size_t tube) const {
    const double white = m_volume.whiteLevel();
    switch (m_route) {
        case Route::exactSums: return profiles.set(tube, m_sums[t], m_config.cellSize, white);
        case Route::singlePrecision:
            return profiles.set(tube, m_means[t], m_config.cellSize, white * slabScale(m_volume));
        case Route::doublePrecision: return profiles.set(tube, m_moments[t], m_config.cellSize);
    }
}

}  // namespace echolucent
