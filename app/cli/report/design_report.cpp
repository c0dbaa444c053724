#include "app/cli/report/design_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/report/report_json.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/designers/choice/designer.h"

namespace echolucent::cli {

namespace {

Json designerParametersJson(const DesignerConfig& config) {
    Json all = Json::object();
    forEachParameter(config, [&](const auto& row, const auto& values) {
        if (const auto value = row.get(values))
            std::visit([&](const auto& plain) { all[std::string(row.name)] = plain; }, *value);
    });
    return all;
}

Json otfObject(const Classification& classification) {
    if (classification.isTwoDimensional()) {
        const TwoDimensionalOtf& otf = *classification.twoDimensional();
        return {{"dimensions", 2},
                {"intensities", otf.intensities},
                {"gradients", otf.gradients},
                {"largest_gradient", otf.largestGradient},
                {"opacity", otf.opacities}};
    }
    Json intensities = Json::array(), opacities = Json::array();
    for (std::size_t i = 0; i < AdaptiveOtf::sampleCount; ++i) {
        intensities.push_back(AdaptiveOtf::intensityOf(i));
        opacities.push_back(opacityAt(classification.curve(), AdaptiveOtf::intensityOf(i)));
    }
    return {{"dimensions", 1}, {"intensity", intensities}, {"opacity", opacities}};
}

Json plotsArray(const Design& design) {
    Json plots = Json::array();
    for (const DesignPlot& plot : design.plots) {
        Json values = Json::array();
        for (const double value : plot.values) values.push_back(finiteJson(value));
        plots.push_back({{"name", plot.name},
                         {"label", plot.label},
                         {"unit", plot.unit},
                         {"intensity", plot.intensities},
                         {"value", values}});
    }
    return plots;
}

}  // namespace

std::string jsonReport(const Volume& volume, const DesignRun& run, const OtfContext& context) {
    const VolumeGeometry& geometry = volume.geometry();
    const ChosenBeam& beam = context.beam;
    Json report;
    report["designer"] = echolucent::nameOf(designerOf(run.config));
    report["message"] = run.design.message;
    report["made_of"] = context.madeOf;
    report["explanation"] = run.design.explanation;
    report["volume"] = {{"size", Json::array({geometry.size[0], geometry.size[1], geometry.size[2]})},
                        {"spacing_mm", vectorJson(geometry.spacing)},
                        {"spacing_known", geometry.spacingKnown},
                        {"type", volume.typeName()},
                        {"white_level", volume.whiteValue()}};
    if (volume.blackValue() != 0.0) report["volume"]["black_level"] = volume.blackValue();
    report["view"] = {{"beam_axis", echolucent::nameOf(run.view.beamAxis)},
                      {"azimuth", run.view.azimuthDegrees},
                      {"elevation", run.view.elevationDegrees},
                      {"front_bowed", run.view.cutSurface.has_value()},
                      {"near_mm", frontDepthMm(run.view)},
                      {"front_forward", frontForwardJson(run.view)}};
    report["beam"] = {{"axis", echolucent::nameOf(beam.axis)},
                      {"source", beam.source},
                      {"confidence", beam.confidence ? Json(*beam.confidence) : Json()}};
    report["reduction"] = echolucent::nameOf(run.reduction);
    report["parameters"] = designerParametersJson(run.config);
    addAdjustment(report["parameters"], context.adjustment);
    report["time_ms"] = run.milliseconds;
    report["finding_ms"] = context.findingMilliseconds;
    report["quietening_ms"] = context.quieteningMilliseconds;
    report["facts"] = Json::object();
    for (const DesignFact& fact : run.design.facts)
        report["facts"][fact.name] = {{"label", fact.label}, {"value", finiteJson(fact.value)}, {"unit", fact.unit}};
    report["plots"] = plotsArray(run.design);
    report["otf"] = otfObject(run.design.classification);
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string curveTable(const Design& design) {
    if (!design.classification.isTwoDimensional()) {
        std::string table = "intensity,opacity\n";
        for (std::size_t i = 0; i < AdaptiveOtf::sampleCount; ++i)
            table += fmt::format("{},{}\n", AdaptiveOtf::intensityOf(i),
                                 opacityAt(design.classification.curve(), AdaptiveOtf::intensityOf(i)));
        return table;
    }
    const TwoDimensionalOtf& otf = *design.classification.twoDimensional();
    std::string table = "intensity,gradient,opacity\n";
    for (int j = 0; j < otf.gradients; ++j)
        for (int i = 0; i < otf.intensities; ++i)
            table += fmt::format("{},{},{}\n", static_cast<double>(i) / (otf.intensities - 1),
                                 otf.largestGradient * j / (otf.gradients - 1),
                                 otf.opacities[static_cast<std::size_t>(j) * static_cast<std::size_t>(otf.intensities) +
                                               static_cast<std::size_t>(i)]);
    return table;
}

std::string summary(const DesignRun& run) {
    std::string text = fmt::format("{}: {} OTF in {:.2f} ms\n", labelOf(designerOf(run.config)),
                                   run.design.classification.isTwoDimensional() ? "two-dimensional" : "one-dimensional",
                                   run.milliseconds);
    for (const std::string& sentence : run.design.explanation) text += sentence + "\n";
    for (const DesignFact& fact : run.design.facts)
        text += fmt::format("{}: {:.6g}{}{}\n", fact.label, fact.value, fact.unit.empty() ? "" : " ", fact.unit);
    if (!run.design.message.empty()) text += run.design.message + "\n";
    return text;
}

}  // namespace echolucent::cli
