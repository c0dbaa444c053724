// One tube core explained: as JSON, as a page, in words.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/explanation/explanation_facts.h"
#include "processing/explanation/tube_explanation.h"
#include "tests/cli/otf_of.h"
#include "tests/cli/program.h"

namespace echolucent {
namespace {

using nlohmann::json;

std::string smallFile() { return phantomFile("explained.mha", "--scene shapes --size 72x68x72 --seed 11"); }
const std::string explainedView = "--beam-axis +z --near 0 --tube-grid 9x8 ";

std::vector<double> doublesOf(const json& list) {
    std::vector<double> values;
    for (const json& value : list) values.push_back(value.is_null() ? std::nan("") : value.get<double>());
    return values;
}

TEST(Explain, JsonHoldsTheExplanationAndWithoutItIsWithoutTube) {
    const std::string number = "40";
    for (const std::string reading : {"published", "default"}) {
        const std::string options = explainedView + "--reading " + reading + " --reduction medium ";
        const json report = otfOf(smallFile(), options + "--explain " + number);
        const json without = otfOf(smallFile(), options + "--without-tube " + number);
        const json& explained = report["explanation"];
        EXPECT_EQ(explained["curves"]["without"]["opacity"], without["otf"]["opacity"]) << reading;
        EXPECT_EQ(explained["curves"]["full"]["opacity"], report["otf"]["opacity"]);
        const json& tube = report["tubes"][40];
        EXPECT_EQ(explained["number"], 40);
        EXPECT_EQ(explained["ranks"]["i_low_max"]["value"], tube["i_low_max"]);
        EXPECT_EQ(explained["ranks"]["slope"]["value"], tube["slope"]);
        EXPECT_EQ(explained["ranks"]["slope"]["weight"], tube["w_slope"]);
    }
}

TEST(Explain, JsonEqualsTheValuesOfTheCore) {
    const Volume volume = *readStudy(smallFile())->phases.front();
    AdaptiveOtfConfig config = configOf(MethodReading::asPublished);
    config.grid.columns = 9;
    config.grid.rows = 8;
    const AdaptiveOtf otf = *adaptOpacity(volume, {}, config);
    const int number = heaviestFirst(otf).front();
    const TubeExplanation expected = *explainTube(volume, {}, otf, number);
    const json explained =
        otfOf(smallFile(), explainedView + "--reading published --explain " + std::to_string(number))["explanation"];
    EXPECT_EQ(doublesOf(explained["axis"]["voxels"]), expected.axis.read);
    EXPECT_EQ(doublesOf(explained["axis"]["slab_means"]), expected.axis.slabMeans);
    EXPECT_EQ(explained["cells"]["surface"], expected.tube.surfaceCell);
    EXPECT_EQ(explained["cells"]["low"], json::array({expected.cells.low.first, expected.cells.low.last}));
    ASSERT_EQ(explained["scales"].size(), expected.scales.size());
    for (std::size_t i = 0; i < expected.scales.size(); ++i) {
        EXPECT_EQ(doublesOf(explained["scales"][i]["function"]), expected.scales[i].function);
        EXPECT_EQ(explained["scales"][i]["cell"], *expected.scales[i].cell);
        EXPECT_EQ(explained["scales"][i]["sigma"].is_null(), !expected.scales[i].sigma);
    }
    EXPECT_EQ(doublesOf(explained["ranks"]["i_low_max"]["values"]), expected.intensityRank.values);
    EXPECT_EQ(explained["ranks"]["i_low_max"]["rank"], expected.intensityRank.rank);
    EXPECT_EQ(doublesOf(explained["curves"]["alone"]["opacity"]), expected.alone.curve.opacities);
    EXPECT_EQ(doublesOf(explained["curves"]["initial"]), expected.initial);
    EXPECT_EQ(explained["factors"].size(), static_cast<std::size_t>(otf.tubesWithWeight));
    EXPECT_EQ(doublesOf(explained["factors"][0]["values"]), expected.factor->values);
    const auto facts = explanationFacts(expected);
    ASSERT_EQ(explained["facts"].size(), facts.size());
    for (std::size_t i = 0; i < facts.size(); ++i) {
        EXPECT_EQ(explained["facts"][i]["key"], facts[i].key);
        EXPECT_EQ(explained["facts"][i]["value"], facts[i].value);
        EXPECT_EQ(explained["facts"][i]["equation"], facts[i].equation);
    }
    EXPECT_EQ(explained["sentence"], explanationSentence(expected));
}

TEST(Explain, APageOpensWithoutANetworkAndHoldsPlotsPicturesAndNumbers) {
    const Folder folder;
    const std::string page = folder / "core.html";
    const Outcome outcome =
        runProgram("otf \"" + smallFile() + "\" " + explainedView + "--explain 40 --page \"" + page + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string text = contentsOf(page);
    const auto count = [&](const std::string& words) {
        std::size_t found = 0;
        for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("<svg "), 7u);
    EXPECT_EQ(count("data:image/png;base64,"), 3u);
    EXPECT_EQ(count("http"), count("http://www.w3.org/2000/svg")) << "nothing is fetched";
    for (const char* words : {"Tube core 40", "d_t = d_max · w_I · w_S", "Petersch 2005, eq. 11", "explained.mha",
                              "Cell size", "echolucent-cli ", "Reading of the paper", "Light", "Without this one"})
        EXPECT_GT(count(words), 0u) << words;
    EXPECT_EQ(count(std::filesystem::path(smallFile()).parent_path().string()), 0u) << "no folder is named";
}

TEST(Explain, APageSaysPhaseInitialFunctionAndTubeCoresThatAreNeverPlaced) {
    const Folder folder;
    const std::string page = folder / "core.html";
    const Outcome outcome =
        runProgram("otf \"" + smallFile() + "\" " + explainedView +
                   "--without-tube 7 --without-tube 30 --opacity-scale 0.5 --explain 40 --page \"" + page + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string text = contentsOf(page);
    for (const char* row : {"<td>Never placed</td><td>7, 30</td>", "<td>Initial function</td><td>a x^2, a = 0.5</td>",
                            "<td>Light</td><td>"})
        EXPECT_NE(text.find(row), std::string::npos) << row;
    for (const char* row : {"<td>Phase</td>", "<td>Render box</td>"})
        EXPECT_EQ(text.find(row), std::string::npos) << row;
}

TEST(Explain, WithoutAFileItIsSaidInWords) {
    const Outcome outcome = runProgram("otf \"" + smallFile() + "\" " + explainedView + "--explain 40");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("Tube core 40 "), std::string::npos);
    EXPECT_NE(outcome.output.find("\nw_I "), std::string::npos);
}

TEST(Explain, IsRefusedInOneSentence) {
    const auto refusal = [](const std::string& options) {
        const Outcome outcome = runProgram("otf \"" + smallFile() + "\" " + explainedView + options);
        EXPECT_EQ(outcome.status, 2) << options;
        EXPECT_EQ(outcome.output, "");
        return outcome.errors;
    };
    const auto says = [&](const std::string& options, const std::string& words) {
        const std::string errors = refusal(options);
        EXPECT_NE(errors.find(words), std::string::npos) << errors;
    };
    says("--explain 72", "--explain must be 0 to 71 in a grid of 9x8 tube cores, not 72");
    says("--explain -1", "must be 0 to 71");
    says("--designer otsu --explain 3", "plays no part beside --designer otsu");
    says("--explain 3 --json - --page -", "can go to standard output");
    says("--page core.html", "plays no part without --explain");
    says("--explain 3 --csv -", "plays no part in tables");
}

}  // namespace
}  // namespace echolucent
