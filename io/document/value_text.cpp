#include "io/document/value_text.h"

#include <nlohmann/json.hpp>

#include "io/document/document_parts.h"
#include "io/json/json_document.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent {

namespace {

using nlohmann::json;

/// The object that a text holds; empty if it holds none.
json objectIn(std::string_view text) {
    json value = json::parse(text, nullptr, false);
    return value.is_object() ? value : json::object();
}

/// Takes the rows of a table from an object, one by one.
template <typename Values>
void takeRows(const json& object, const ParameterTable<Values>& table, Values& values) {
    for (const Parameter<Values>& row : table) {
        JsonProblems problems;
        Values taken = values;
        JsonFields(object, {}, problems).parameters(ParameterTable<Values>{.rows = {row}}, taken);
        if (!problems.first) values = taken;
    }
}

/// The motion of an object; no value if something is missing or wrong.
std::optional<MotionChoice> motionOf(const json& object) {
    JsonProblems problems;
    JsonFields fields(object, {}, problems);
    const MotionChoice motion = motionIn(fields);
    return problems.first || !problemOf(motion).empty() ? std::nullopt : std::optional(motion);
}

/// The config that the rows of a method's text change. Texts from before the aim hold none, and mean the curve of
/// bright surfaces.
AdaptiveOtfConfig configWithoutParameters(const json& method) {
    const auto parameters = method.find("parameters");
    const bool before = parameters != method.end() && parameters->is_object() && !parameters->contains("aim");
    return configOf(before ? MethodReading::firstVersion : MethodReading::standard);
}

}  // namespace

std::string textOf(const Look& look) { return lookJson(look).dump(); }
std::string textOf(const MethodChoice& method) { return methodJson(method).dump(); }
std::string textOf(const MotionChoice& motion) { return motionJson(motion).dump(); }

Look lookFromText(std::string_view text) {
    Look look = lookParameters().standard;
    takeRows(objectIn(text), lookParameters(), look);
    return look;
}

MethodChoice methodFromText(std::string_view text) {
    const json object = objectIn(text);
    MethodChoice method;
    takeRows(object, initialFunctionParameters(), method);
    const AdaptiveOtfConfig standard = configWithoutParameters(object);
    method.config = standard;
    if (const auto parameters = object.find("parameters"); parameters != object.end() && parameters->is_object())
        takeRows(*parameters, methodParameters(), method.config);
    method.config.initial = AdaptiveOtfConfig{}.initial;
    if (!problemOf(method.config).empty()) method.config = standard;
    return method;
}

MotionChoice motionFromText(std::string_view text) {
    const json object = objectIn(text);
    json whole = json::parse(textOf(MotionChoice{}));
    for (const auto& [key, value] : object.items()) {
        json changed = whole;
        changed[key] = value;
        if (motionOf(changed)) whole = std::move(changed);
    }
    return motionOf(whole).value();
}

}  // namespace echolucent
