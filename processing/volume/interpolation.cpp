#include "processing/volume/interpolation.h"

#include <algorithm>
#include <array>

namespace echolucent {

namespace {
constexpr std::array<std::string_view, 2> interpolationNames{"nearest", "trilinear"};
}

std::string_view nameOf(Interpolation interpolation) {
    return interpolationNames[static_cast<std::size_t>(interpolation)];
}

std::optional<Interpolation> interpolationFromName(std::string_view name) {
    const auto* found = std::find(interpolationNames.begin(), interpolationNames.end(), name);
    if (found == interpolationNames.end()) return std::nullopt;
    return static_cast<Interpolation>(found - interpolationNames.begin());
}

}  // namespace echolucent
