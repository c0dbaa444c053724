// Values that stand both in documents and in files of presets.
#pragma once

#include <nlohmann/json.hpp>

#include "io/json_fields.h"
#include "processing/document/document.h"

namespace echolucent {

/// What a table says of values; rows that mean nothing in them are left out.
template <typename Values>
nlohmann::ordered_json parametersJson(std::span<const Parameter<Values>> table, const Values& values) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const Parameter<Values>& row : table)
        if (const auto value = row.get(values))
            std::visit([&](const auto& plain) { object[std::string(row.name)] = plain; }, *value);
    return object;
}

[[nodiscard]] nlohmann::ordered_json lookJson(const Look& look);
/// What is missing is that of lookAtStart().
[[nodiscard]] Look lookIn(JsonFields& fields);

/// The largest opacity scale and slope that a curve in a file may have, that of the method's opacity scale.
[[nodiscard]] double largestScale();

[[nodiscard]] nlohmann::ordered_json curvesJson(const CurveSet& curves);
[[nodiscard]] CurveSet curvesIn(JsonFields fields);

/// All but the direction. Where all tube cores are placed, no key says so.
[[nodiscard]] nlohmann::ordered_json methodJson(const MethodChoice& method);
/// The direction stays as by default.
[[nodiscard]] MethodChoice methodIn(JsonFields& fields);

}  // namespace echolucent
