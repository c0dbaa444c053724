#include "processing/designers/adaptive_design.h"

#include <string>
#include <utility>
#include <variant>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/designers/adaptive_words.h"
#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

namespace {

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
    if (tubeCoresMadeTheCurve(otf)) {
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
        add("aim", "Aim: bright surfaces (0) to every wall (1)", std::get<RampRule>(otf.config.curve).aim, "share");
        if (otf.everyWall) {
            add("every_wall_begin", "Ramp for every wall: clear up to", otf.everyWall->begin);
            add("every_wall_end", "Ramp for every wall: full from", otf.everyWall->end);
            add("every_wall_opacity", "Ramp for every wall: opacity per unit", otf.everyWall->opacity);
        }
    }
    if (otf.reduction != SpeckleReduction::off && otf.speckleLeft)
        add("speckle_left", "Speckle left in the shown voxels", *otf.speckleLeft, "share");
    return facts;
}

DesignPlot initialFunction(const OpacityCurve& initial) {
    DesignPlot plot{"initial", "Initial function", "opacity per unit", {}, {}};
    plot.values = sampledOpacities(initial, AdaptiveOtf::sampleCount);
    for (int i = 0; i < AdaptiveOtf::sampleCount; ++i)
        plot.intensities.push_back(static_cast<double>(i) / (AdaptiveOtf::sampleCount - 1));
    return plot;
}

std::vector<std::string> explanationOf(const AdaptiveOtf& otf) {
    std::vector<std::string> sentences;
    if (const std::size_t left = otf.config.grid.withoutTubes.size(); left > 0)
        sentences.push_back(std::to_string(left) + (left == 1 ? " tube core was" : " tube cores were") +
                            " left out by hand and " + (left == 1 ? "is" : "are") + " never placed.");
    if (!tubeCoresMadeTheCurve(otf)) return sentences;  // the message says all
    sentences.push_back(surfaceSentence(otf));
    sentences.push_back(detectionSentence(otf.config));
    if (otf.lengthsHalved)
        sentences.emplace_back(
            "The volume has few voxels, so all lengths along the tube cores are half of what was set.");
    sentences.push_back(curveSentence(otf));
    if (const std::string voxels = voxelsSentence(otf); !voxels.empty()) sentences.push_back(voxels);
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
