#include "widgets/casting/qualities.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

RayCastSettings settingsAt(std::size_t quality, const RayCastSettings& asked) {
    const Quality& chosen = qualities.at(quality);
    RayCastSettings settings = asked;
    settings.width = std::max(1, static_cast<int>(std::lround(asked.width / chosen.reduction)));
    settings.height = std::max(1, static_cast<int>(std::lround(asked.height / chosen.reduction)));
    settings.step = asked.step * chosen.step;
    settings.terminationTransmittance = chosen.terminationTransmittance;
    settings.pixelTolerance = chosen.pixelTolerance;
    // Pictures shown at rest have the same light, so that light and shade do not move from one picture to the next.
    if (!chosen.atRest) settings.lightCoarseness = 2 * asked.lightCoarseness;
    return settings;
}

std::size_t nextAtRest(std::size_t quality) {
    do --quality;
    while (!qualities.at(quality).atRest);
    return quality;
}

}  // namespace echolucent
