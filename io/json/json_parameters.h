// Writes the values of a table of parameters as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "processing/parameters/parameter.h"

namespace echolucent {

/// The values of a table's rows. Rows without a meaning for these values are left out.
template <typename Values>
nlohmann::ordered_json parametersJson(const ParameterTable<Values>& table, const Values& values) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const Parameter<Values>& row : table)
        if (const auto value = row.get(values))
            std::visit([&](const auto& plain) { object[std::string(row.name)] = plain; }, *value);
    return object;
}

}  // namespace echolucent
