#include "processing/tube_core/tube_reader.h"

#include <utility>

namespace echolucent {

TubeReader::TubeReader(const Volume& volume, const CellRule& rule)
    : m_volume(volume),
      m_rule(rule),
      m_storedLimit(exactStoredLimit(volume)),
      m_interpolating(rule.precision == Precision::single32 && canMeanSlabs(volume) ? Route::singlePrecision
                                                                                    : Route::doublePrecision),
      m_route(m_interpolating) {}

void TubeReader::read(std::span<const TubeSamples> tubes) {
    m_route = m_storedLimit && !tubes.empty() && tubes.front().onVoxels ? Route::exactSums : m_interpolating;
    switch (m_route) {
        case Route::exactSums:
            m_sums.resize(tubes.size());
            sumSlabs(m_volume, *m_storedLimit, tubes, m_sums);
            break;
        case Route::singlePrecision:
            m_means.resize(tubes.size());
            meanSlabs(m_volume, m_rule.sampling, tubes, m_means);
            break;
        case Route::doublePrecision:
            m_moments.resize(tubes.size());
            for (std::size_t t = 0; t < tubes.size(); ++t)
                sampleSlabs(m_volume, m_rule.sampling, tubes[t], m_moments[t], m_values);
            break;
    }
}

double TubeReader::whiteLevel() const {
    return m_route == Route::singlePrecision ? m_volume.whiteLevel() * slabScale(m_volume) : m_volume.whiteLevel();
}

TubeSlabs TubeReader::slabsAt(std::size_t place) {
    switch (m_route) {
        case Route::exactSums: return {std::move(m_sums[place]), whiteLevel()};
        case Route::singlePrecision: return {std::move(m_means[place]), whiteLevel()};
        case Route::doublePrecision: break;
    }
    return {std::move(m_moments[place]), whiteLevel()};
}

void TubeReader::profile(std::size_t place, TubeProfiles& profiles, std::size_t tube) const {
    switch (m_route) {
        case Route::exactSums: return profiles.set(tube, m_sums[place], m_rule.size, whiteLevel());
        case Route::singlePrecision: return profiles.set(tube, m_means[place], m_rule.size, whiteLevel());
        case Route::doublePrecision: return profiles.set(tube, m_moments[place], m_rule.size);
    }
}

}  // namespace echolucent
