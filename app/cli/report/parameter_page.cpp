#include "app/cli/report/parameter_page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/options/option_text.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/designers/choice/designer.h"
#include "processing/document/curve_adjustment.h"
#include "processing/document/method_choice.h"
#include "processing/picture/look.h"

namespace echolucent::cli {

namespace {

Json wordsJson(std::string_view words) { return words.empty() ? Json(nullptr) : Json(words); }

Json rangeJson(const ParameterRange& range) {
    return Json::array({finiteJson(range.least), finiteJson(range.largest)});
}

std::string_view kindOf(const ParameterValue& value) {
    if (std::holds_alternative<bool>(value)) return "flag";
    if (std::holds_alternative<std::string>(value)) return "choice";
    return std::holds_alternative<std::int64_t>(value) ? "whole number" : "number";
}

Json rowJson(const ParameterDefault& each) {
    const AnyParameter& row = *each.row;
    Json json{{"name", row.name},
              {"label", row.label},
              {"meaning", row.meaning},
              {"kind", kindOf(each.standard)},
              {"unit", wordsJson(row.unit)}};
    if (numberOf(each.standard)) {
        json["range"] = rangeJson(row.range);
        json["offered"] = rangeJson(row.offeredRange());
    }
    for (const ParameterChoice& choice : row.choices)
        json["choices"].push_back({{"name", choice.name}, {"label", labelOf(choice)}});
    json["default"] = std::visit([](const auto& value) { return Json(value); }, each.standard);
    json["applies"] = whenOf(row);
    json["source"] = row.source;
    return json;
}

template <typename Values>
Json tableJson(const ParameterTable<Values>& table) {
    Json rows = Json::array();
    for (const ParameterDefault& row : defaultsOf(table)) rows.push_back(rowJson(row));
    return rows;
}

}  // namespace

std::string parameterPage(const std::vector<ParameterDefault>& rows) {
    std::string page = "| option | meaning | values | default | with | chosen by |\n|---|---|---|---|---|---|\n";
    for (const auto& [row, standard] : rows) {
        std::string values;
        for (const ParameterChoice& choice : row->choices)
            values += fmt::format("{}`{}`", values.empty() ? "" : ", ", choice.name);
        if (row->choices.empty()) values = textOf(row->range.least) + " to " + textOf(row->range.largest);
        if (!row->unit.empty()) values += fmt::format(", {}", row->unit);
        const ParameterScope& scope = row->scope;
        const std::string with =
            scope.parameter.empty() ? std::string() : fmt::format("`{} {}`", optionOf(scope.parameter), scope.choice);
        page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", optionOf(row->name), row->meaning, values,
                            wordOf(standard), with, row->source);
    }
    return page;
}

std::string allParametersJson() {
    Json designers = Json::object();
    for (const Designer designer : allDesigners)
        designers[std::string(echolucent::nameOf(designer))] =
            std::visit([](const auto& values) { return tableJson(parametersOf(values)); }, defaultConfigOf(designer));
    // The adaptive designer runs the method, with the method's parameters.
    designers[std::string(AdaptiveConfig::words.name)] = tableJson(methodParameters());
    const Json all{{"method", tableJson(methodParameters())},
                   {"initial_function", tableJson(initialFunctionParameters())},
                   {"designers", designers},
                   {"look", tableJson(lookParameters())},
                   {"curve_adjustment", tableJson(adjustmentParameters())}};
    return all.dump(1) + "\n";
}

}  // namespace echolucent::cli
