#include <nlohmann/json.hpp>
#include <string>

#include "otf_of.h"
#include "program.h"

namespace echolucent {
namespace {

using nlohmann::json;

/// The parameters of an OTF of a small volume: they do not ask what it shows.
json parametersOf(const std::string& options) {
    return otfOf(phantomFile("small.mha", "--scene shapes --size 44x40x48 --seed 5"), options)["parameters"];
}

TEST(OtfReading, SetsEverythingAndIsNamedInTheReport) {
    const json standard = parametersOf("");
    EXPECT_EQ(standard["reading"], "default");
    EXPECT_EQ(parametersOf("--reading default"), standard);
    const json settled = parametersOf("--reading settled");
    EXPECT_EQ(settled["reading"], "settled");
    EXPECT_EQ(settled["interface_function"], "variance");
    EXPECT_EQ(settled["form"], "product");
    EXPECT_EQ(settled["floor_quantile"], 0.0);
    EXPECT_EQ(settled["kernel_end"], "cut");
    EXPECT_EQ(settled["coarsest_maximum"], "needed");
    const json published = parametersOf("--reading published");
    EXPECT_EQ(published["reading"], "published");
    EXPECT_EQ(published["border"], "circular");
    EXPECT_EQ(published["smoothing_route"], "fourier");
    EXPECT_EQ(published["tracking_range"], 2.0);
    EXPECT_EQ(published["significance"], 0.0);
    EXPECT_EQ(published["prior_cells"], "overlapping");
    EXPECT_EQ(published["rank_bins"], 256);
    EXPECT_DOUBLE_EQ(published["d_max"].get<double>(), 6.75 / published["tubes_meeting_volume"].get<int>());
}

TEST(OtfReading, IsOverriddenOnlyByWhatStandsOnTheCommandLine) {
    const json published = parametersOf("--reading published");
    // An option on the command line counts in either order, also where its value is the default's.
    for (const std::string options :
         {"--reading published --significance 0.4", "--significance 0.4 --reading published"}) {
        json expected = published;
        expected["significance"] = 0.4;
        expected["reading"] = nullptr;
        EXPECT_EQ(parametersOf(options), expected);
    }
    json fewer = published;
    const json got = parametersOf("--reading published --tube-grid 9x8");
    EXPECT_EQ(got["reading"], "published") << "the grid belongs to no reading";
    EXPECT_EQ(got["tube_grid"], (json{9, 8}));
}

TEST(OtfReading, WhatDoesNotApplyIsLeftOutOfTheReport) {
    const json standard = parametersOf("--tube-grid 3x3"), settled = parametersOf("--tube-grid 3x3 --reading settled");
    for (const char* key : {"significance", "coarsest_scale", "border", "strength", "least_edge_to_noise"}) {
        EXPECT_FALSE(standard.contains(key)) << key;
        EXPECT_TRUE(settled.contains(key)) << key;
    }
    for (const char* key : {"false_alarm", "least_step", "ramp_begin", "trusted_share"}) {
        EXPECT_TRUE(standard.contains(key)) << key;
        EXPECT_FALSE(settled.contains(key)) << key;
    }
    for (const char* key : {"cell_size", "low_reach", "rank_bins", "tube_grid", "d_max", "opacity_scale"})
        EXPECT_TRUE(standard.contains(key) && settled.contains(key)) << key;
}

TEST(OtfReading, EveryOptionIsTakenUp) {
    struct Row {
        std::string option, word, key;
        json value;
    };
    for (const Row& row :
         {Row{"--interface-function", "variance", "interface_function", "variance"},
          Row{"--interface-function", "ratio", "interface_function", "ratio"},
          Row{"--form", "product", "form", "product"},
          Row{"--form", "ramp", "form", "ramp"},
          Row{"--interface-function variance --border", "circular", "border", "circular"},
          Row{"--reading published --border", "mirror", "border", "mirror"},
          Row{"--reading published --smoothing-route", "direct", "smoothing_route", "direct"},
          Row{"--reading settled --smoothing-route", "fourier", "smoothing_route", "fourier"},
          Row{"--interface-function variance --kernel-end", "cut", "kernel_end", "cut"},
          Row{"--interface-function variance --coarsest-maximum", "needed", "coarsest_maximum", "needed"},
          Row{"--interface-function variance --tracking-range", "2.5", "tracking_range", 2.5},
          Row{"--prior-cells", "overlapping", "prior_cells", "overlapping"},
          Row{"--rank-bins", "16", "rank_bins", 16},
          Row{"--sampling", "nearest", "sampling", "nearest"},
          Row{"--precision", "double", "precision", "double"},
          Row{"--low-reach", "7", "low_reach", 7},
          Row{"--high-reach", "3", "high_reach", 3},
          Row{"--false-alarm", "4.5", "false_alarm", 4.5},
          Row{"--form product --strength", "3.5", "strength", 3.5},
          Row{"--interface-function variance --sigma", "0.5", "sigma_per_kernel_size", 0.5},
          Row{"--reading settled --interface-function ratio --least-ratio", "3", "least_ratio", 3.0},
          Row{"--ramp-begin", "0.4", "ramp_begin", 0.4},
          Row{"--ramp-end", "1.7", "ramp_end", 1.7},
          Row{"--ramp-opacity", "0.5", "ramp_opacity", 0.5},
          Row{"--trusted-share", "0.2", "trusted_share", 0.2}})
        EXPECT_EQ(parametersOf("--tube-grid 3x3 " + row.option + " " + row.word)[row.key], row.value) << row.option;
}

TEST(OtfReading, RoutesAgreeAndBordersDoNot) {
    const auto dOf = [](const std::string& options) {
        std::vector<double> all;
        const json otf = otfOf(shapesFile(), "--reading settled " + options);
        for (const json& tube : otf["tubes"]) all.push_back(tube["d"]);
        return all;
    };
    const auto direct = dOf("");
    EXPECT_EQ(dOf("--smoothing-route fourier"), direct) << "rounding decides nowhere";
    EXPECT_NE(dOf("--border circular"), direct);
}

TEST(OtfReading, WhatIsNoChoiceIsSaid) {
    for (const auto& [options, says] :
         {std::pair<std::string, std::string>{"--reading literal", "published, settled, 0.1 or default"},
          {"--reading settled --border mirrored", "mirror or circular"},
          {"--reading settled --smoothing-route fft", "direct or fourier"},
          {"--rank-bins -1", "--rank-bins must be 0 to 1048576"},
          {"--reading settled --tracking-range nan", "--tracking-range must be 0 to 1000"},
          {"--significance 0.3", "--significance belongs to --interface-function variance, and ratio is chosen"},
          {"--reading settled --false-alarm 3", "belongs to --interface-function ratio, and variance is chosen"},
          {"--strength 3", "--strength belongs to --form product, and ramp is chosen"},
          {"--reading published --ramp-begin 0.3", "--ramp-begin belongs to --form ramp, and product is chosen"},
          {"--ramp-begin 2", "ramp must end"}}) {
        const Outcome outcome = runProgram("otf \"" + shapesFile() + "\" " + options);
        EXPECT_EQ(outcome.status, 2) << options;
        EXPECT_NE(outcome.errors.find(says), std::string::npos) << outcome.errors;
    }
}

TEST(OtfReading, RenderTakesItToo) {
    const Folder folder;
    const auto picture = [&](const std::string& name, const std::string& options) {
        const Outcome outcome =
            runProgram("render \"" + shapesFile() + "\" --size 64x64 -o \"" + folder / name + "\" " + options);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        return contentsOf(folder / name);
    };
    EXPECT_NE(picture("a.png", "--reading published"), picture("b.png", "--reading default"));
}

}  // namespace
}  // namespace echolucent
