// The tables and the summary of an OTF.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "otf_of.h"
#include "program.h"
#include "tables.h"

namespace echolucent {
namespace {

using nlohmann::json;

TEST(OtfTables, HoldTheSameNumbersAsTheJson) {
    const Folder folder;
    const Outcome outcome =
        runProgram("otf \"" + shapesFile() + "\" --form product --json \"" + folder / "o.json" + "\" --csv \"" +
                   folder / "o.csv" + "\" --tubes-csv \"" + folder / "t.csv" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    const json otf = json::parse(contentsOf(folder / "o.json"));
    const auto curve = rowsOf(contentsOf(folder / "o.csv"));
    ASSERT_EQ(curve.size(), 257u);
    EXPECT_EQ(curve[0], (std::vector<std::string>{"intensity", "opacity", "log_opacity", "initial_opacity"}));
    EXPECT_EQ(curve[1][2], "") << "ln 0";
    for (std::size_t i = 1; i < 256; ++i) {
        EXPECT_EQ(std::stod(curve[i + 1][0]), otf["otf"]["intensity"][i].get<double>());
        EXPECT_EQ(std::stod(curve[i + 1][1]), otf["otf"]["opacity"][i].get<double>());
        EXPECT_EQ(std::stod(curve[i + 1][2]), otf["otf"]["log_opacity"][i].get<double>());
    }
    const auto tubes = rowsOf(contentsOf(folder / "t.csv"));
    ASSERT_EQ(tubes.size(), 226u);
    for (const auto& row : tubes) EXPECT_EQ(row.size(), tubes[0].size());
    EXPECT_EQ(tubes[0].back(), "d");
    for (std::size_t t = 0; t < 225; ++t) EXPECT_EQ(std::stod(tubes[t + 1].back()), otf["tubes"][t]["d"].get<double>());
}

TEST(OtfSummary, IsPrintedWhereNoFileIsAskedFor) {
    const Outcome outcome = runProgram("otf \"" + shapesFile() + "\"");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.output.find("of 225 tube cores meet the volume"), std::string::npos);
    EXPECT_NE(outcome.output.find("110x100x120 uint8"), std::string::npos);
}

}  // namespace
}  // namespace echolucent
