#include "io/json/json_document.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "io/json/json_parameters.h"
#include "io/json/json_values.h"
#include "processing/adaptive/method_parameters.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

constexpr const char* withoutTubesKey = "without_tubes";

}  // namespace

double largestScale() {
    static const double largest = parameterNamed(methodParameters(), "opacity_scale")->range.largest;
    return largest;
}

ordered_json lookJson(const Look& look) { return parametersJson(lookParameters(), look); }

Look lookIn(JsonFields& fields) {
    Look look = lookParameters().standard;
    fields.parameters(lookParameters(), look);
    return look;
}

ordered_json linearCurveJson(const LinearCurve& curve) {
    return {{"lower", curve.lower}, {"slope", curve.slope}, {"upper", curve.upper}};
}

LinearCurve linearCurveIn(JsonFields fields) {
    LinearCurve curve;
    curve.lower = fields.number("lower", 0, 1);
    curve.slope = fields.number("slope", 0, largestScale());
    curve.upper = fields.number("upper", curve.lower, 1);
    return curve;
}

ordered_json curvesJson(const CurveSet& curves) {
    return {{"manual", manualCurveJson(curves.manual)},
            {"linear", linearCurveJson(curves.linear)},
            {"parabolic", {{"scale", curves.parabolic.scale}}},
            {"quartic", {{"scale", curves.quartic.scale}}},
            {"adjustment", parametersJson(adjustmentParameters(), curves.adjustment)}};
}

CurveSet curvesIn(JsonFields fields) {
    CurveSet curves;
    curves.manual = manualCurveIn(fields, "manual");
    curves.linear = linearCurveIn(fields.object("linear"));
    curves.parabolic.scale = fields.object("parabolic").number("scale", 0, largestScale());
    curves.quartic.scale = fields.object("quartic").number("scale", 0, largestScale());
    JsonFields adjustment = fields.object("adjustment");
    for (const Parameter<CurveAdjustment>& row : adjustmentParameters())
        row.set(curves.adjustment,
                adjustment.number(std::string(row.name).c_str(), row.range.least, row.range.largest));
    return curves;
}

ordered_json methodParametersJson(const AdaptiveOtfConfig& config) {
    ordered_json parameters = parametersJson(methodParameters(), config);
    parameters.erase("opacity_scale");  // belongs to the initial function, which stands beside the config
    return parameters;
}

AdaptiveOtfConfig methodParametersIn(JsonFields& fields) {
    AdaptiveOtfConfig config;
    fields.parameters(methodParameters(), config);
    config.initial = AdaptiveOtfConfig{}.initial;
    return config;
}

ordered_json methodJson(const MethodChoice& method) {
    ordered_json parameters = methodParametersJson(method.config);
    if (const auto& without = method.config.grid.withoutTubes; !without.empty()) parameters[withoutTubesKey] = without;
    ordered_json object = parametersJson(initialFunctionParameters(), method);
    object["parameters"] = parameters;
    return object;
}

MethodChoice methodIn(JsonFields& fields) {
    MethodChoice method;
    method.initial = fields.choice("initial", &initialKindFromName);
    method.initialScale = fields.number("initial_scale", 0, largestScale());
    JsonFields parameters = fields.object("parameters");
    // Files from before the aim hold none, and mean the curve of bright surfaces.
    if (!parameters.has("aim")) std::get<RampRule>(method.config.curve).aim = 0.0;
    parameters.parameters(methodParameters(), method.config);
    if (parameters.has(withoutTubesKey)) {
        const auto without = parameters.wholes(withoutTubesKey, 0, std::numeric_limits<int>::max());
        method.config.grid.withoutTubes.assign(without.begin(), without.end());
    }
    method.config.initial = AdaptiveOtfConfig{}.initial;
    if (const std::string problem = problemOf(method.config); !problem.empty()) fields.wrong("parameters", problem);
    return method;
}

}  // namespace echolucent
