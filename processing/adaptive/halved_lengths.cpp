#include "processing/adaptive/halved_lengths.h"

#include <algorithm>
#include <array>
#include <variant>

namespace echolucent {

namespace {

constexpr int half(int length) { return (length + 1) / 2; }

RatioRule halved(RatioRule rule) {
    rule.slabsBefore = half(rule.slabsBefore);
    rule.slabsBehind = half(rule.slabsBehind);
    rule.rampSlabs = half(rule.rampSlabs);
    rule.leastFluid = half(rule.leastFluid);
    rule.leastDark = half(rule.leastDark);
    return rule;
}

SurfaceRule halved(SurfaceRule rule) {
    rule.lowReach = half(rule.lowReach);
    rule.highReach = half(rule.highReach);
    rule.slopeHalfStep = half(rule.slopeHalfStep);
    return rule;
}

AdaptiveOtfConfig halved(AdaptiveOtfConfig config, const RatioRule& ratio) {
    config.cells.size = half(config.cells.size);
    config.detection = halved(ratio);
    config.surface = halved(config.surface);
    return config;
}

bool hasDefaultLengths(const AdaptiveOtfConfig& config, const RatioRule& rule) {
    const auto lengthsOf = [](const RatioRule& one) {
        return std::array{one.slabsBefore, one.slabsBehind, one.rampSlabs, one.leastFluid, one.leastDark};
    };
    return config.cells.size == CellRule{}.size && config.surface == SurfaceRule{} &&
           lengthsOf(rule) == lengthsOf(RatioRule{});
}

}  // namespace

std::optional<AdaptiveOtfConfig> halvedLengths(const AdaptiveOtfConfig& config, const VolumeGeometry& geometry) {
    const auto* ratio = std::get_if<RatioRule>(&config.detection);
    if (ratio == nullptr || !hasDefaultLengths(config, *ratio)) return std::nullopt;
    const Vec3 lengthMm = geometry.boxMaxMm() - geometry.boxMinMm();
    if (std::max({lengthMm[0], lengthMm[1], lengthMm[2]}) >= coarseUnits * geometry.unit()) return std::nullopt;
    return halved(config, *ratio);
}

AdaptiveOtfConfig configUsed(const AdaptiveOtf& otf) {
    return otf.lengthsHalved ? halved(otf.config, std::get<RatioRule>(otf.config.detection)) : otf.config;
}

}  // namespace echolucent
