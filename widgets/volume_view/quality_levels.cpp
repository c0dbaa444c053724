#include "widgets/volume_view/quality_levels.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

RayCastSettings settingsAt(std::size_t level, const RayCastSettings& asked) {
    const QualityLevel& quality = qualityLevels.at(level);
    RayCastSettings settings = asked;
    settings.width = std::max(1, static_cast<int>(std::lround(asked.width / quality.reduction)));
    settings.height = std::max(1, static_cast<int>(std::lround(asked.height / quality.reduction)));
    settings.step = asked.step * quality.step;
    settings.terminationTransmittance = quality.terminationTransmittance;
    return settings;
}

std::size_t nextAtRest(std::size_t level) {
    do --level;
    while (!qualityLevels.at(level).atRest);
    return level;
}

}  // namespace echolucent
