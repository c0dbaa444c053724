// A table of parameters as a page of docs/ has it.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "processing/parameter.h"

namespace echolucent::cli {

/// A value as people write it on the command line.
[[nodiscard]] inline std::string wordOf(const ParameterValue& value) {
    if (const auto number = numberOf(value)) return textOf(*number);
    if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
    return std::get<std::string>(value);
}

/// One row a parameter, in the table's order, as a table in Markdown; ends with a newline.
template <typename Values>
[[nodiscard]] std::string parameterPage(std::span<const Parameter<Values>> table) {
    std::string page = "| option | meaning | values | default | with | chosen by |\n|---|---|---|---|---|---|\n";
    for (const Parameter<Values>& row : table) {
        std::string values;
        for (const std::string_view choice : row.choices)
            values += fmt::format("{}`{}`", values.empty() ? "" : ", ", choice);
        if (row.choices.empty()) values = textOf(row.range.least) + " to " + textOf(row.range.largest);
        if (!row.unit.empty()) values += fmt::format(", {}", row.unit);
        const std::string scope = row.scope.parameter.empty()
                                      ? std::string()
                                      : fmt::format("`{} {}`", optionOf(row.scope.parameter), row.scope.choice);
        page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", optionOf(row.name), row.meaning, values,
                            wordOf(defaultOf(table, row)), scope, row.source);
    }
    return page;
}

}  // namespace echolucent::cli
