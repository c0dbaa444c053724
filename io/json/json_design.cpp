#include "io/json/json_design.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/json/json_document.h"
#include "io/json/json_parameters.h"
#include "io/json/json_values.h"
#include "processing/designers/choice/designer.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

void writeMore(const KindlmannConfig& config, ordered_json& object) {
    std::vector<std::array<double, 2>> nodes;
    for (const EmphasisNode& node : config.drawn) nodes.push_back({node.position, node.opacity});
    object["drawn"] = nodes;
}

/// A curve of any kind; "kind" names it.
ordered_json curveJson(const OpacityCurve& curve) {
    if (const auto* manual = std::get_if<ManualCurve>(&curve))
        return {{"kind", "manual"}, {"nodes", manualCurveJson(*manual)}};
    if (const auto* linear = std::get_if<LinearCurve>(&curve))
        return {{"kind", "linear"}, {"lower", linear->lower}, {"slope", linear->slope}, {"upper", linear->upper}};
    if (const auto* power = std::get_if<PowerCurve>(&curve))
        return {{"kind", "power"}, {"exponent", power->exponent}, {"scale", power->scale}};
    return {{"kind", "sampled"}, {"opacities", std::get<SampledCurve>(curve).opacities}};
}

OpacityCurve curveIn(JsonFields fields) {
    constexpr std::int64_t largestExponent = 64;
    const std::string kind = fields.text("kind");
    if (kind == "manual") return manualCurveIn(fields, "nodes");
    if (kind == "linear") {
        const double lower = fields.number("lower", 0, 1);
        return LinearCurve{lower, fields.number("slope", 0, largestScale()), fields.number("upper", lower, 1)};
    }
    if (kind == "power")
        return PowerCurve{static_cast<int>(fields.whole("exponent", 1, largestExponent)),
                          fields.number("scale", 0, largestScale())};
    if (kind != "sampled") fields.wrong("kind", "must be manual, linear, power or sampled");
    SampledCurve curve{fields.numbers("opacities")};
    const auto isOpacity = [](double opacity) { return opacity >= 0.0 && opacity <= 1.0; };
    if (curve.opacities.size() < 2 || !std::ranges::all_of(curve.opacities, isOpacity))
        fields.wrong("opacities", "must be two or more numbers from 0 to 1");
    return curve;
}

void writeMore(const TemplateConfig& config, ordered_json& object) {
    object["reference"] = {{"name", config.reference->name},
                           {"histogram", config.reference->histogram},
                           {"curve", curveJson(config.reference->curve)}};
}
template <typename Config>
void writeMore(const Config&, ordered_json&) {}

void readMore(JsonFields& fields, KindlmannConfig& config) {
    if (!fields.has("drawn")) return;
    config.drawn.clear();
    for (const auto& [position, opacity] : fields.pairs("drawn", mostEmphasisNodes))
        config.drawn.push_back({position, opacity});
}
void readMore(JsonFields& fields, TemplateConfig& config) {
    if (!fields.has("reference")) return;
    JsonFields reference = fields.object("reference");
    TemplateReference read{reference.text("name"), reference.numbers("histogram"), curveIn(reference.object("curve"))};
    config.reference = std::move(read);
    if (const std::string problem = problemOf(config); !problem.empty()) fields.wrong("reference", problem);
}
template <typename Config>
void readMore(JsonFields&, Config&) {}

}  // namespace

ordered_json designJson(const DesignerConfig& config) {
    ordered_json object{{"designer", nameOf(designerOf(config))}};
    std::visit(
        [&](const auto& values) {
            object["parameters"] = parametersJson(parametersOf(values), values);
            writeMore(values, object);
        },
        config);
    return object;
}

DesignerConfig designIn(JsonFields& fields) {
    DesignerConfig config = defaultConfigOf(fields.choice("designer", &designerFromName));
    std::visit(
        [&](auto& values) {
            if (fields.has("parameters")) fields.object("parameters").parameters(parametersOf(values), values);
            readMore(fields, values);
        },
        config);
    return config;
}

}  // namespace echolucent
