#include "processing/designers/adaptive_design.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

namespace {

int surfacesFound(const AdaptiveOtf& otf) {
    return static_cast<int>(std::ranges::count(otf.tubes, TubeStatus::surface, &TubeCore::status));
}

double sumOfD(const AdaptiveOtf& otf) {
    return std::accumulate(otf.tubes.begin(), otf.tubes.end(), 0.0,
                           [](double sum, const TubeCore& tube) { return sum + tube.d; });
}

std::vector<DesignFact> adaptiveFacts(const AdaptiveOtf& otf) {
    std::vector<DesignFact> facts{
        {"tube_cores", "Tube cores that meet the volume", static_cast<double>(otf.tubesMeetingVolume)},
        {"surfaces", "Surfaces found", static_cast<double>(surfacesFound(otf))},
        {"surfaces_with_weight", "Surfaces with a weight", static_cast<double>(otf.tubesWithWeight)}};
    const auto add = [&](const char* name, const char* label, double value, const char* unit = "") {
        facts.push_back({name, label, value, unit});
    };
    if (const std::size_t left = otf.config.grid.withoutTubes.size(); left > 0)
        add("never_placed", "Tube cores never placed", static_cast<double>(left));
    if (otf.tubesWithWeight > 0 && !otf.surfacesWhereDataBegin) {
        const MeanInterface mean = meanInterfaceOf(otf);
        add("low_intensity", "Mean intensity before the surfaces (I_L)", mean.low);
        add("high_intensity", "Mean intensity at the surfaces (I_H)", mean.high);
    }
    if (otf.fluidIntensity) add("fluid_level", "Fluid level", *otf.fluidIntensity);
    if (const auto* product = std::get_if<ProductRule>(&otf.config.curve)) {
        add("strength", "Strength (T times d_max)", product->strength);
        add("sum_of_d", "Sum of d", sumOfD(otf));
    } else {
        add("trust", "Share of the curve that is the tube cores'", otf.trust, "share");
    }
    if (otf.reduction != SpeckleReduction::off)
        add("speckle_left", "Speckle left in the shown voxels", otf.speckleLeft, "share");
    return facts;
}

DesignPlot initialFunction(const OpacityCurve& initial) {
    DesignPlot plot{"initial", "Initial function", "opacity per unit", {}, {}};
    plot.values = sampledOpacities(initial, AdaptiveOtf::sampleCount);
    for (int i = 0; i < AdaptiveOtf::sampleCount; ++i)
        plot.intensities.push_back(static_cast<double>(i) / (AdaptiveOtf::sampleCount - 1));
    return plot;
}

/// With at most two decimals.
std::string hundredthsInWords(double value) { return textOf(std::round(value * 100.0) / 100.0); }
std::string wholePercentInWords(double share) { return textOf(std::round(share * 100.0)) + " %"; }

std::string surfaceSentence(const AdaptiveOtf& otf) {
    const MeanInterface mean = meanInterfaceOf(otf);
    const bool ramp = std::holds_alternative<RampRule>(otf.config.curve);
    return std::to_string(surfacesFound(otf)) + " of " + std::to_string(otf.tubesMeetingVolume) +
           " tube cores (columns of voxels along the view) found a surface behind darker tissue or fluid, and " +
           std::to_string(otf.tubesWithWeight) + " of these have a weight. In front of it the intensity is about " +
           hundredthsInWords(mean.low) +
           (ramp ? " and stays clear, at it about " : " and becomes clearer, at it about ") +
           hundredthsInWords(mean.high) + (ramp ? " and becomes opaque." : " and becomes more opaque.");
}

std::string curveSentence(const AdaptiveOtf& otf) {
    if (const auto* product = std::get_if<ProductRule>(&otf.config.curve))
        return "The curve is the initial function times one basis function for each tube core, with a strength of " +
               hundredthsInWords(product->strength) + ", of which " + hundredthsInWords(sumOfD(otf)) + " is used.";
    std::string sentence =
        "The curve is the mean of one ramp for each tube core, clear up to its fluid and full from its surface on.";
    if (otf.trust < 1.0)
        sentence += " As few tube cores found a surface, " + wholePercentInWords(1.0 - otf.trust) +
                    " of the curve is the initial function.";
    return sentence;
}

std::vector<std::string> explanationOf(const AdaptiveOtf& otf) {
    std::vector<std::string> sentences;
    if (const std::size_t left = otf.config.grid.withoutTubes.size(); left > 0)
        sentences.push_back(std::to_string(left) + (left == 1 ? " tube core was" : " tube cores were") +
                            " left out by hand and " + (left == 1 ? "is" : "are") + " never placed.");
    if (otf.tubesWithWeight == 0 || otf.surfacesWhereDataBegin) return sentences;  // the message says all
    sentences.push_back(surfaceSentence(otf));
    sentences.emplace_back(
        std::holds_alternative<RatioRule>(otf.config.detection)
            ? "Surfaces are looked for where it is much brighter behind than before, by the ratio of means."
            : "Surfaces are looked for where the intensity varies most, from coarse to fine scales.");
    if (otf.lengthsHalved)
        sentences.emplace_back(
            "The volume has few voxels, so all lengths along the tube cores are half of what was set.");
    sentences.push_back(curveSentence(otf));
    if (otf.reduction != SpeckleReduction::off)
        sentences.push_back(
            "The tube cores read the voxels as they were measured; the curve is meant for the quiet ones, "
            "in which " +
            wholePercentInWords(otf.speckleLeft) + " of the fluid's speckle is left.");
    return sentences;
}

}  // namespace

const ParameterTable<AdaptiveConfig>& parametersOf(const AdaptiveConfig& /*config*/) {
    static const ParameterTable<AdaptiveConfig> table;
    return table;
}

std::optional<Design> design(const AdaptiveConfig& /*config*/, const DesignerInput& input, const Progress& progress) {
    auto otf = adaptOpacity(input.raw, input.view, input.method, progress, {&input.shown, input.reduction});
    if (!otf) return std::nullopt;
    return designOf(std::make_shared<const AdaptiveOtf>(std::move(*otf)));
}

Design designOf(std::shared_ptr<const AdaptiveOtf> otf) {
    return {.classification = otf->curve,
            .explanation = explanationOf(*otf),
            .facts = adaptiveFacts(*otf),
            .plots = {initialFunction(otf->config.initial)},
            .message = otf->message,
            .tubeCores = std::move(otf)};
}

}  // namespace echolucent
