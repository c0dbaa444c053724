#include "processing/theory/theory_curves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/adaptive/found_ramp.h"
#include "processing/choice_names.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> scalingNames{"same scale", "same at tissue"};

OpacityCurve times(LinearCurve curve, double factor) {
    curve.slope *= factor;
    return curve;
}
OpacityCurve times(PowerCurve curve, double factor) {
    curve.scale *= factor;
    return curve;
}
OpacityCurve times(ManualCurve curve, double factor) {
    for (CurveNode& node : curve.nodes) node.opacity = std::min(1.0, node.opacity * factor);
    return curve;
}
OpacityCurve times(SampledCurve curve, double factor) {
    for (double& opacity : curve.opacities) opacity = std::min(1.0, opacity * factor);
    return curve;
}

/// The model's ray up to as far behind the surface as *every wall* reads.
AxisProfile profileOf(const TwoIntensities& model) {
    // Thicker fluid changes nothing at the surface, but a ramp that is not quite clear in it.
    constexpr std::int64_t mostFluid = 4096;
    const std::int64_t before = std::min(model.fluidUnits, mostFluid);
    AxisProfile profile;
    profile.intensities.assign(static_cast<std::size_t>(before), static_cast<float>(model.fluid));
    profile.intensities.insert(profile.intensities.end(), static_cast<std::size_t>(missedUnits),
                               static_cast<float>(model.tissue));
    profile.surface = static_cast<double>(before);
    return profile;
}

}  // namespace

std::string_view nameOf(OpacityScaling scaling) { return nameIn(scalingNames, scaling); }

std::optional<OpacityScaling> opacityScalingFromName(std::string_view name) {
    return choiceNamed<OpacityScaling>(scalingNames, name);
}

SampledCurve adaptiveCurveOf(const TwoIntensities& model, const AdaptiveOtfConfig& config) {
    if (const std::string problem = problemOf(model); !problem.empty())
        throw std::invalid_argument("adaptiveCurveOf: " + problem);
    TubeCore tube;
    tube.status = TubeStatus::surface;
    tube.lowIntensity = model.fluid;
    tube.highIntensity = model.tissue;
    tube.fluidSpread = 0.0;
    tube.d = model.tissue > model.fluid ? strengthOf(config.curve) : 0.0;
    const std::vector<TubeCore> tubes{tube};
    std::optional<FoundRamp> everyWall;
    if (asksForEveryWall(config.curve)) {
        const std::vector<AxisProfile> profiles{profileOf(model)};
        everyWall = rampForEveryWall(profiles, tubes);
    }
    return adaptedCurve(config.curve, config.initial, tubes, AdaptiveOtf::sampleCount, everyWall).curve;
}

std::vector<TheoryCurve> theoryCurves(const GivenCurves& given, const TwoIntensities& model) {
    return {{"linear, x", PowerCurve{1, 1.0}},
            {"parabolic, x²", given.parabolic},
            {"quartic, x⁴", given.quartic},
            {"eq. 1", given.equation1},
            {"adaptive", given.adaptive ? *given.adaptive : adaptiveCurveOf(model)}};
}

OpacityCurve scaledCurve(const OpacityCurve& curve, double factor) {
    if (!(factor >= 0.0) || !std::isfinite(factor))
        throw std::invalid_argument("scaledCurve: the factor must be finite and not negative");
    return std::visit([factor](const auto& shape) { return times(shape, factor); }, curve);
}

std::vector<TheoryCurve> scaledCurves(std::vector<TheoryCurve> curves, OpacityScaling scaling, double scale,
                                      double tissue) {
    for (TheoryCurve& named : curves) {
        const double opacity = opacityAt(named.curve, tissue);
        if (scaling == OpacityScaling::sameScale)
            named.curve = scaledCurve(named.curve, scale);
        else if (opacity > 0.0)
            named.curve = scaledCurve(named.curve, std::min(1.0, scale * tissue) / opacity);
    }
    return curves;
}

}  // namespace echolucent
