#include "processing/adaptive/adapted_curve.h"

#include <algorithm>
#include <cmath>

#include "processing/tube_core/basis_function.h"
#include "processing/tube_core/ramp.h"
#include "processing/tube_core/tube_weights.h"

namespace echolucent {

namespace {

AdaptedCurve byRule(const ProductRule& /*rule*/, const OpacityCurve& initial, std::span<const TubeCore> tubes,
                    int count, const std::optional<FoundRamp>& /*everyWall*/) {
    return {adaptedLogOpacity(initial, tubes, count), {}, 1.0};
}

AdaptedCurve byRule(const RampRule& rule, const OpacityCurve& initial, std::span<const TubeCore> tubes, int count,
                    const std::optional<FoundRamp>& everyWall) {
    AdaptedCurve adapted{meanRamp(tubes, rule, count), {}, 0.0};
    std::vector<double>& curve = adapted.logOpacity;
    const double needed = rule.trustedShare * tubesMeetingVolume(tubes);
    if (!curve.empty()) adapted.trust = needed > 0.0 ? std::min(1.0, tubesWithWeight(tubes) / needed) : 1.0;
    curve.resize(static_cast<std::size_t>(count), 0.0);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double x = static_cast<double>(i) / (count - 1);
        if (everyWall) curve[i] = (1.0 - rule.aim) * curve[i] + rule.aim * opacityAt(*everyWall, x);
        if (adapted.trust == 0.0)
            curve[i] = logOpacityAt(initial, x);
        else
            curve[i] =
                std::log(adapted.trust * rule.opacity * curve[i] + (1.0 - adapted.trust) * opacityAt(initial, x));
    }
    return adapted;
}

}  // namespace

bool asksForEveryWall(const CurveRule& rule) {
    const auto* ramp = std::get_if<RampRule>(&rule);
    return ramp != nullptr && ramp->aim > 0.0;
}

CurveRule withoutEveryWall(CurveRule rule) {
    if (auto* ramp = std::get_if<RampRule>(&rule)) ramp->aim = 0.0;
    return rule;
}

AdaptedCurve adaptedCurve(const CurveRule& rule, const OpacityCurve& initial, std::span<const TubeCore> tubes,
                          int count, const std::optional<FoundRamp>& everyWall) {
    AdaptedCurve adapted =
        std::visit([&](const auto& one) { return byRule(one, initial, tubes, count, everyWall); }, rule);
    adapted.curve = curveFromLogOpacity(adapted.logOpacity);
    // Without a weight, take the initial function itself: the way over its logarithm would round it.
    if (tubesWithWeight(tubes) == 0) adapted.curve.opacities = sampledOpacities(initial, count);
    return adapted;
}

}  // namespace echolucent
