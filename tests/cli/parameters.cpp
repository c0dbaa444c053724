// The real program's `parameters`, and the page of docs/ that holds what it prints.
#include <nlohmann/json.hpp>

#include "processing/adaptive/method_parameters.h"
#include "processing/designers/choice/designer.h"
#include "processing/picture/look.h"
#include "tests/cli/program.h"

namespace echolucent {
namespace {

using nlohmann::json;

TEST(Parameters, ThePageHoldsWhatTheProgramPrints) {
    const Outcome outcome = runProgram("parameters");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("| `--cell-size` |"), std::string::npos);
    const std::string page = contentsOf(std::string(ECHOLUCENT_SOURCE_DIR) + "/docs/cli-otf.md");
    EXPECT_NE(page.find("-->\n" + outcome.output + "<!-- End of the table. -->"), std::string::npos)
        << "put what `echolucent-cli parameters` prints into docs/cli-otf.md";
}

json allParameters() {
    const Outcome outcome = runProgram("parameters --json");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return json::parse(outcome.output);
}

/// What the rows of a table say, read by their keys.
template <typename Values>
void expectRows(const json& rows, const ParameterTable<Values>& table) {
    ASSERT_EQ(rows.size(), table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Parameter<Values>& row = table.rows[i];
        const ParameterValue standard = defaultOf(table, row);
        EXPECT_EQ(rows[i]["name"], row.name);
        EXPECT_EQ(rows[i]["meaning"], row.meaning);
        EXPECT_EQ(rows[i]["source"], row.source);
        EXPECT_EQ(rows[i]["applies"], whenOf(row));
        EXPECT_EQ(rows[i]["default"], std::visit([](const auto& value) { return json(value); }, standard)) << row.name;
        if (numberOf(standard)) {
            EXPECT_EQ(rows[i]["range"], json({row.range.least, row.range.largest})) << row.name;
        }
        EXPECT_EQ(rows[i].value("choices", json::array()).size(), row.choices.size()) << row.name;
    }
}

TEST(Parameters, JsonHoldsEveryRowOfEveryTable) {
    const json all = allParameters();
    expectRows(all["method"], methodParameters());
    expectRows(all["look"], lookParameters());
    EXPECT_EQ(all["curve_adjustment"].size(), 2u);
    EXPECT_EQ(all["initial_function"].size(), 2u);
    ASSERT_EQ(all["designers"].size(), allDesigners.size());
    EXPECT_EQ(all["designers"]["adaptive"], all["method"]);
    for (const Designer designer : allDesigners) {
        if (designer == designerOf(AdaptiveConfig{})) continue;
        const DesignerConfig config = defaultConfigOf(designer);
        std::visit(
            [&](const auto& values) {
                expectRows(all["designers"][std::string(nameOf(designer))], parametersOf(values));
            },
            config);
    }
}

TEST(Parameters, JsonSaysWhatKindOfValueAndWhenItApplies) {
    const json all = allParameters();
    const auto rowOf = [](const json& rows, const std::string& name) {
        for (const json& row : rows)
            if (row["name"] == name) return row;
        return json();
    };
    EXPECT_EQ(rowOf(all["method"], "tube_columns")["kind"], "whole number");
    EXPECT_EQ(rowOf(all["method"], "tube_columns")["offered"], json({1.0, 4096.0}));
    EXPECT_EQ(rowOf(all["method"], "strength")["applies"], "if form is product");
    EXPECT_EQ(rowOf(all["look"], "depth_colouring")["kind"], "flag");
    EXPECT_EQ(rowOf(all["look"], "mode")["choices"][3], json({{"name", "mean"}, {"label", "Mean (x-ray)"}}));
    EXPECT_EQ(rowOf(all["look"], "light_azimuth")["unit"], "degrees");
    EXPECT_EQ(rowOf(all["initial_function"], "initial_scale")["applies"], "if initial is parabolic or quartic");
    EXPECT_EQ(rowOf(all["initial_function"], "initial_scale")["meaning"],
              "Opacity of the initial function at full intensity");
    EXPECT_EQ(rowOf(all["designers"]["levoy"], "levels")["choices"][0]["label"], "Tube cores");
}

}  // namespace
}  // namespace echolucent
