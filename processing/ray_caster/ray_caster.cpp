#include "processing/ray_caster.h"

#include <algorithm>
#include <array>
#include <utility>

namespace echolucent {

namespace {
constexpr std::array<std::string_view, 4> renderModeNames{"direct", "maximum", "minimum", "mean"};
}

std::string_view nameOf(RenderMode mode) { return renderModeNames[static_cast<std::size_t>(mode)]; }

std::optional<RenderMode> renderModeFromName(std::string_view name) {
    const auto* found = std::find(renderModeNames.begin(), renderModeNames.end(), name);
    if (found == renderModeNames.end()) return std::nullopt;
    return static_cast<RenderMode>(found - renderModeNames.begin());
}

class RayCaster::Parts {
public:
    std::shared_ptr<const Volume> volume;
};

RayCaster::RayCaster(std::shared_ptr<const Volume> volume) : m_parts(std::make_unique<Parts>()) {
    m_parts->volume = std::move(volume);
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

const std::shared_ptr<const Volume>& RayCaster::volume() const { return m_parts->volume; }

std::optional<Picture> RayCaster::cast(const OpacityCurve& curve, const RayCastSettings& settings,
                                       const Progress& progress) {
    return castRays(*m_parts->volume, curve, settings, progress);
}

std::size_t RayCaster::keptSampleBytes() const { return 0; }

}  // namespace echolucent
