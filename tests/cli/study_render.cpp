// The real program's `study render`, and the parts of it that decide what is shown.
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "app/measuring/render/study_render.h"
#include "tests/cli/program.h"
#include "tests/cli/tables.h"

namespace echolucent {
namespace {

/// The key is made of route, parameter and value, as "kernel step 0.5".
std::map<std::string, NamedRow> rowsByName(const std::string& csv) {
    std::map<std::string, NamedRow> rows;
    for (const NamedRow& row : namedRowsOf(csv)) {
        const std::string name = row.at("route") + " " + row.at("parameter") + " " + row.at("value");
        EXPECT_TRUE(rows.emplace(name, row).second) << "twice: " << name;
    }
    return rows;
}

double number(const std::map<std::string, NamedRow>& rows, const std::string& name, const std::string& column) {
    const auto found = rows.find(name);
    EXPECT_NE(found, rows.end()) << name;
    return found == rows.end() ? NAN : std::stod(found->second.at(column));
}

const std::string quickStudy = "study render --quick --size 48x40 --phantom-size 40 --repeats 1 -o ";

TEST(LongStudyRender, ErrorsAreOrderedAsTheyMustBe) {
    const Folder folder;
    const Outcome outcome =
        runProgram(quickStudy + "\"" + folder / "deep/er" + "\" --otf parabolic --opacity-scale 0.5");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto rows = rowsByName(contentsOf(folder / "deep/er/render.csv"));
    const auto rmse = [&](const std::string& name) { return number(rows, name, "rmse"); };
    const double reference = rmse("kernel reference step 1");
    EXPECT_EQ(number(rows, "kernel reference step 1", "time_ratio"), 1.0);
    EXPECT_GT(reference, 0.0);
    EXPECT_LT(rmse("kernel step 0.25"), 0.5 * reference);
    EXPECT_GT(rmse("kernel step 4"), 2.0 * reference);
    EXPECT_GT(rmse("kernel interpolation nearest"), reference);
    EXPECT_LT(rmse("kernel resolution 1/2"), rmse("kernel resolution 1/4"));
    EXPECT_LT(std::abs(rmse("plain precision double, step 1") - reference), 0.2)
        << "the plain route at the kernel's settings errs as the kernel does";
    const double inDouble = rmse("plain precision double, step 1");
    EXPECT_GT(rmse("plain ends double, step 1, whole steps only"), 1.5 * inDouble);
    EXPECT_GT(number(rows, "plain precision 8 bit, step 1", "precision_rmse"),
              number(rows, "plain precision half, step 1", "precision_rmse"));
    EXPECT_LT(number(rows, "plain precision single, step 1", "precision_rmse"), 1e-3);
    for (const auto& [name, row] : rows) {
        EXPECT_GE(number(rows, name, "maximum"), number(rows, name, "rmse")) << name;
        EXPECT_LE(number(rows, name, "ssim"), 1.0) << name;
        EXPECT_GT(number(rows, name, "time_ms"), 0.0) << name;
        EXPECT_TRUE(row.at("route") == "kernel" || row.at("front") == "0") << "plain times do not compare: " << name;
    }
}

TEST(LongStudyRender, WritesPagePlotAndSentences) {
    const Folder folder;
    const Outcome outcome = runProgram(quickStudy + "\"" + folder / "out" + "\" --shade");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("The front of the kernel's settings"), std::string::npos);
    const std::string page = contentsOf(folder / "out/render.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    for (const char* part :
         {"The same rays", "data:image/png;base64,", "high quality", "<title>A, reference step 1: 1, "})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_LE(page.size(), HtmlPage::mostBytes);
    EXPECT_TRUE(contentsOf(folder / "out/render-pareto.svg").starts_with("<svg"));
    // "... at equal settings: X levels"
    const std::string words = "at equal settings: ";
    const auto at = outcome.output.find(words);
    ASSERT_NE(at, std::string::npos);
    EXPECT_LT(std::stod(outcome.output.substr(at + words.size())), 1.0) << "levels between kernel and plain route";
}

TEST(LongStudyRender, TakesAVolume) {
    const Folder folder;
    const Outcome outcome = runProgram("study render \"" + shapesFile() +
                                       "\" --size 32x32 --repeats 1 --otf linear -o \"" + folder / "out" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("110x100x120"), std::string::npos);
}

TEST(StudyRender, RefusesInOneSentence) {
    const Folder folder;
    for (const std::string options : {"", "-o x --size 5x5", "-o x --otf nonsense", "-o x --repeats 0",
                                      "-o x --phantom-size 4", "-o x --beam-axis q"}) {
        const Outcome outcome = runProgram("study render " + options);
        EXPECT_EQ(outcome.status, 2) << options << outcome.errors;
        EXPECT_FALSE(outcome.errors.empty());
    }
    write(folder / "file", "");
    EXPECT_EQ(runProgram("study render --quick --phantom-size 16 -o \"" + folder / "file" + "\"").status, 4);
    EXPECT_EQ(runProgram("study render nowhere.mha -o \"" + folder / "out" + "\"").status, 3);
}

cli::RenderResult renderResult(double milliseconds, double rmse, double largest = 0.0) {
    cli::RenderResult result;
    result.milliseconds = milliseconds;
    result.error.rmse = rmse;
    result.error.largest = largest;
    return result;
}

TEST(StudyRender, TheFrontIsWhatNoSettingOfTheKernelBeats) {
    std::vector<cli::RenderResult> results{renderResult(1, 5), renderResult(2, 1),   renderResult(2, 2),
                                           renderResult(3, 1), renderResult(9, 0.5), renderResult(0.1, 0.1)};
    results.back().variant.plain = PlainCasting{};
    cli::markFront(results);
    const std::vector<bool> expected{true, true, false, false, true, false};
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(results[i].onFront, expected[i]) << i;
}

TEST(StudyRender, TheFastestSettingKeepsBothBounds) {
    std::vector<cli::RenderResult> results{renderResult(1, 3, 3), renderResult(2, 0.5, 20), renderResult(3, 0.9, 7),
                                           renderResult(4, 0.1, 1), renderResult(0.5, 0.1, 1)};
    results.back().variant.plain = PlainCasting{};
    EXPECT_EQ(cli::fastestWithin({"", 1.0, 8.0}, results), &results[2]);
    EXPECT_EQ(cli::fastestWithin({"", 1.0}, results), &results[1]);
    EXPECT_EQ(cli::fastestWithin({"", 0.01}, results), nullptr);
}

TEST(StudyRender, NoSettingStandsTwice) {
    for (const bool shaded : {false, true}) {
        RayCastSettings reference;
        reference.width = 511;
        reference.height = 300;
        if (shaded) reference.shading = Shading{};
        const auto variants = cli::renderVariants(reference);
        EXPECT_EQ(variants.front().settings, reference);
        std::set<std::string> names;
        for (std::size_t i = 0; i < variants.size(); ++i) {
            EXPECT_TRUE(names.insert(variants[i].name()).second) << variants[i].name();
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(variants[i].settings == variants[k].settings && variants[i].plain == variants[k].plain)
                    << variants[i].name() << " and " << variants[k].name();
        }
    }
}

/// The picture is linear in place: pixel (x, y) of a picture that stands for [0,1]^2.
Picture plane(int width, int height) {
    Picture picture{width, height, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5) / width, v = (y + 0.5) / height;
            for (const double value : {u, v, 0.25 * u + 0.5 * v, 1.0})
                picture.rgba.push_back(static_cast<float>(value));
        }
    return picture;
}

TEST(StudyRender, EnlargingKeepsPlaces) {
    const int width = 60, height = 45;
    const Picture whole = plane(width, height);
    for (const auto& [columns, rows] : {std::pair(30, 22), std::pair(40, 30), std::pair(20, 15), std::pair(60, 45)}) {
        const Picture large = cli::enlarged(plane(columns, rows), width, height);
        ASSERT_EQ(large.rgba.size(), whole.rgba.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                // The place lies within the outermost centres of the small picture.
                const double u = (x + 0.5) / width * columns, v = (y + 0.5) / height * rows;
                if (u < 0.5 || u > columns - 0.5 || v < 0.5 || v > rows - 0.5) continue;
                const auto at = static_cast<std::size_t>(y * width + x) * 4;
                for (std::size_t channel = 0; channel < 4; ++channel)
                    EXPECT_NEAR(large.rgba[at + channel], whole.rgba[at + channel], 1e-6) << x << ", " << y;
            }
        EXPECT_FLOAT_EQ(large.rgba[0], 0.5f / static_cast<float>(columns)) << "clamped at the edge";
    }
}

TEST(StudyRender, MiddleAndOverviewAreOfTheRightPlaces) {
    const Picture whole = plane(60, 45);
    const Picture middle = cli::middleOf(whole, 20, 99);
    EXPECT_EQ(middle.width, 20);
    EXPECT_EQ(middle.height, 45);
    EXPECT_EQ(middle.rgba[0], whole.rgba[20 * 4]);
    EXPECT_EQ(middle.rgba.back(), whole.rgba[(44 * 60 + 39) * 4 + 3]);
    const Picture overview = cli::overviewOf(whole, 20);
    EXPECT_EQ(overview.width, 20);
    EXPECT_EQ(overview.height, 15);
    const Picture expected = plane(20, 15);
    for (std::size_t i = 0; i < expected.rgba.size(); ++i) EXPECT_NEAR(overview.rgba[i], expected.rgba[i], 1e-6);
}

}  // namespace
}  // namespace echolucent
