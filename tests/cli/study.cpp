// The real program's `study`: the files it writes, what they hold, and how it refuses.
#include <cmath>
#include <vector>

#include "app/measuring/otf/study_otf.h"
#include "processing/adaptive/method_parameters.h"
#include "tests/cli/program.h"
#include "tests/cli/tables.h"

namespace echolucent {
namespace {

const std::string onSmallPhantoms = " --phantoms --size 64 --repeats 1";

TEST(LongStudyOtf, OnPhantomsWritesPageTablesAndPlots) {
    const Folder folder;
    const Outcome outcome = runProgram("study otf -o \"" + folder / "deep/er" + "\"" + onSmallPhantoms);
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("CNR_S"), std::string::npos);
    const std::string page = contentsOf(folder / "deep/er/otf.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    for (const char* part : {"Curve by variance", "Detection by ratio", "hard_log_compressed", "all ordinary"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_TRUE(contentsOf(folder / "deep/er/otf-pareto-ratio.svg").starts_with("<svg"));

    const auto settings = namedRowsOf(contentsOf(folder / "deep/er/otf-settings.csv"));
    int references = 0, onFront = 0;
    for (const NamedRow& row : settings) {
        EXPECT_GT(std::stod(row.at("time_ratio")), 0.0);
        EXPECT_LE(std::stod(row.at("rms_difference")), std::stod(row.at("max_difference")));
        onFront += row.at("front") == "1";
        if (row.at("reference") != "1") continue;
        ++references;
        EXPECT_EQ(row.at("max_difference"), "0");
        EXPECT_EQ(row.at("front"), "0");
    }
    EXPECT_EQ(references, 2);
    EXPECT_GE(onFront, 2);

    const auto readings = namedRowsOf(contentsOf(folder / "deep/er/otf-readings.csv"));
    // There are 12 conditions, two views and three readings.
    EXPECT_EQ(readings.size(), 72U);
    int contrasts = 0;
    for (const NamedRow& row : readings) contrasts += !row.at("cnr_s").empty();
    EXPECT_EQ(contrasts, 18);
}

TEST(StudyOtf, OnAVolumeKnowsNoDetection) {
    const Folder folder;
    const Outcome outcome =
        runProgram("study otf \"" + shapesFile() + "\" --repeats 1 --view-azimuth 10 -o \"" + folder / "out" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    for (const NamedRow& row : namedRowsOf(contentsOf(folder / "out/otf-settings.csv")))
        EXPECT_EQ(row.at("right_weight_share"), "");
    const std::string page = contentsOf(folder / "out/otf.html");
    EXPECT_EQ(page.find("Detection by"), std::string::npos);
    EXPECT_NE(page.find("light from the surfaces"), std::string::npos);
}

TEST(StudyOtf, RefusesInOneSentence) {
    const Folder folder;
    for (const std::string& options :
         {std::string("-o x"), "--phantoms -o x \"" + shapesFile() + "\"", std::string("--phantoms"),
          std::string("--phantoms -o x --seeds a"), std::string("--phantoms -o x --size 4"),
          std::string("--phantoms -o x --repeats 0")}) {
        const Outcome outcome = runProgram("study otf " + options);
        EXPECT_EQ(outcome.status, 2) << options << outcome.errors;
        EXPECT_FALSE(outcome.errors.empty());
    }
    write(folder / "file", "");
    EXPECT_EQ(runProgram("study otf --phantoms --size 32 -o \"" + folder / "file" + "\"").status, 4);
    EXPECT_EQ(runProgram("study otf nowhere.mha -o \"" + folder / "out" + "\"").status, 3);
    EXPECT_EQ(runProgram("study").status, 2);
    EXPECT_EQ(runProgram("study nonsense").status, 2);
}

TEST(LongStudyContrast, IsTheSameForAnyNumberOfThreads) {
    const Folder folder;
    const std::string options = "study contrast --size 72 --seeds 3 --csv ";
    const Outcome one = runProgram("--threads 1 " + options + "\"" + folder / "one.csv" + "\"");
    const Outcome three = runProgram("--threads 3 " + options + "\"" + folder / "three.csv" + "\"");
    ASSERT_EQ(one.status, 0) << one.errors;
    EXPECT_EQ(one.output, three.output);
    const std::string csv = contentsOf(folder / "one.csv");
    EXPECT_EQ(csv, contentsOf(folder / "three.csv"));
    EXPECT_EQ(namedRowsOf(csv).size(), 30U);  // six conditions, five curves
}

cli::VariantResult variantResult(double timeRatio, double error, bool isReference = false) {
    cli::VariantResult result;
    result.variant.isReference = isReference;
    result.timeRatios = {timeRatio};
    result.sumOfSquares = error * error;
    result.samples = 1;
    return result;
}

TEST(StudyOtf, TheFrontIsWhatNothingBeats) {
    std::vector<cli::VariantResult> results{variantResult(1, 0.5), variantResult(2, 0.1),     variantResult(2, 0.2),
                                            variantResult(3, 0.1), variantResult(4, 0, true), variantResult(0.5, 0.9)};
    // The same figures by the other interface function stand on a front of their own.
    results.push_back(variantResult(5, 5));
    results.back().variant.interfaceFunction = "ratio";
    cli::markFront(results);
    const std::vector<bool> expected{true, true, false, false, false, true, true};
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(results[i].onFront, expected[i]) << i;
}

TEST(StudyOtf, RatiosAreAveragedGeometrically) {
    cli::VariantResult result = variantResult(0.5, 0);
    result.timeRatios.push_back(2.0);
    EXPECT_DOUBLE_EQ(result.timeRatio(), 1.0);
}

TEST(StudyOtf, EveryVariantIsAConfigThatCanBe) {
    VolumeGeometry geometry;
    for (const std::int64_t edge : {1, 7, 199}) {
        geometry.size = {edge, edge, edge};
        for (const cli::OtfVariant& variant : cli::otfVariants(geometry, Viewpoint{}))
            EXPECT_EQ(problemOf(variant.config), "") << variant.name();
    }
}

}  // namespace
}  // namespace echolucent
