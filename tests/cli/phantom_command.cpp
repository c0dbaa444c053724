// The real program's `phantom` command: what it writes, what it says is true of it, and how it refuses.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/io/written_files/python_script.h"

namespace {

namespace fs = std::filesystem;
using echolucent::runTool;
using echolucent::ToolOutcome;
using nlohmann::json;

/// What the command ends with; both streams are its output.
ToolOutcome run(const std::string& options) { return runTool(std::string(ECHOLUCENT_CLI) + " " + options + " 2>&1"); }

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

class PhantomCommand : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("echolucent-phantom-" + std::to_string(::getpid()));
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }
    std::string path(const std::string& name) const { return (m_folder / name).string(); }
    /// Writes a phantom with its truth and gives the truth.
    json truthOf(const std::string& options) const {
        const ToolOutcome outcome = run("phantom " + path("v.mha") + " --truth " + path("t.json") + " " + options);
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return json::parse(contentOf(path("t.json")));
    }
    std::string header() const {
        const std::string content = contentOf(path("v.mha"));
        return content.substr(0, content.find("ElementDataFile"));
    }

    fs::path m_folder;
};

TEST_F(PhantomCommand, EveryOptionReachesTheVolume) {
    const json truth = truthOf(
        "--scene shapes --size 40x36x44 --spacing 0.5x0.6x0.7 --speckle 0.25 --speckle-size 3 --contrast 20,90,180 "
        "--ramp 2 "
        "--gain-variation 0.1 --attenuation 0.004 --shadow 0.03 --specular 0.4 --log-compress 60 --front-wall --bits "
        "12 "
        "--seed 9");
    const json& config = truth.at("config");
    const json expected = {{"scene", "shapes"},
                           {"size", {40, 36, 44}},
                           {"spacing_mm", {0.5, 0.6, 0.7}},
                           {"fluid", 20.0},
                           {"tissue", 90.0},
                           {"object", 180.0},
                           {"ramp_units", 2.0},
                           {"gain_variation", 0.1},
                           {"speckle", 0.25},
                           {"attenuation_per_unit", 0.004},
                           {"shadow_per_unit", 0.03},
                           {"specular", 0.4},
                           {"log_compress_db", 60.0},
                           {"front_wall", true},
                           {"bits", 12},
                           {"seed", 9},
                           {"speckle_size_voxels", 3.0}};
    EXPECT_EQ(config, expected);
    EXPECT_NE(header().find("DimSize = 40 36 44"), std::string::npos) << header();
    EXPECT_NE(header().find("MET_USHORT"), std::string::npos);
    EXPECT_NE(header().find("WhiteLevel = 4095"), std::string::npos);
}

TEST_F(PhantomCommand, DefaultsFollowTheScene) {
    EXPECT_EQ(truthOf("--size 16").at("config").at("scene"), "fetus");
    EXPECT_GT(truthOf("--size 16").at("config").at("shadow_per_unit"), 0.0);
    EXPECT_EQ(truthOf("--size 16 --shadow 0").at("config").at("shadow_per_unit"), 0.0);
    const json shapes = truthOf("--size 16 --scene shapes").at("config");
    EXPECT_EQ(shapes.at("speckle"), 0.5);
    EXPECT_EQ(shapes.at("attenuation_per_unit"), 0.0);
}

TEST_F(PhantomCommand, TruthGivesEachTubeItsDepth) {
    // The view is along +z with cubic voxels, so that the depth is the surface's z beyond the entry.
    const json truth = truthOf("--scene shapes --size 128 --tube-grid 9x7 --tube-spacing 13");
    EXPECT_EQ(truth.at("tubes").size(), 63U);
    EXPECT_EQ(truth.at("tube_grid").at("spacing_units"), (json{13.0, 13.0}));
    EXPECT_EQ(truth.at("primitives").size(), 10U);
    int found = 0;
    for (const json& tube : truth.at("tubes")) {
        ASSERT_FALSE(tube.at("entry_voxel").is_null());
        EXPECT_EQ(tube.at("corner_depths_units").size(), 4U);
        if (tube.at("depth_units").is_null()) continue;
        ++found;
        const double depth = tube.at("depth_units"), from = tube.at("entry_voxel")[2], to = tube.at("surface_voxel")[2];
        EXPECT_NEAR(depth, to - from, 1e-9);
        EXPECT_GT(depth, 8);
    }
    EXPECT_GT(found, 30);
    EXPECT_LT(found, 63);
    const json empty = truthOf("--scene empty --size 32");
    for (const json& tube : empty.at("tubes")) EXPECT_TRUE(tube.at("depth_units").is_null());
}

TEST_F(PhantomCommand, TruthFollowsTheView) {
    const json truth = truthOf("--scene shapes --size 96 --view-azimuth 30 --near 4");
    EXPECT_NEAR(truth.at("view").at("direction_mm")[0], 0.5, 1e-12);
    EXPECT_EQ(truth.at("view").at("near_mm"), 4.0);
    EXPECT_NE(truth.at("tubes"), truthOf("--scene shapes --size 96").at("tubes"));
}

TEST_F(PhantomCommand, PhasesMakeAFourDimensionalFile) {
    const json truth = truthOf("--phases 4 --size 40");
    EXPECT_NE(header().find("NDims = 4"), std::string::npos);
    EXPECT_NE(header().find("DimSize = 40 40 40 4"), std::string::npos);
    ASSERT_EQ(truth.at("phases").size(), 4U);
    EXPECT_EQ(truth.at("phases")[1].at("phase"), 0.25);
    EXPECT_NE(truth.at("phases")[1].at("primitives"), truth.at("primitives"));
    EXPECT_EQ(truth.at("phases")[0].at("tubes"), truth.at("tubes"));
}

TEST_F(PhantomCommand, TheEndingChoosesTheFormat) {
    ASSERT_EQ(run("phantom " + path("v.mha") + " --size 24x20x16 --phases 2 --bits 16").status, 0);
    ASSERT_EQ(run("phantom " + path("v.dcm") + " --size 24x20x16 --phases 2 --bits 16").status, 0);
    EXPECT_EQ(contentOf(path("v.dcm")).substr(128, 4), "DICM");
    const ToolOutcome same = run("info " + path("v.dcm"));
    EXPECT_NE(same.output.find("DICOM Enhanced US Volume, one file, 2 phases of 16 frames"), std::string::npos);
    // The same voxels, geometry and view give the same curves.
    for (const std::string name : {"v.dcm", "v.mha"})
        ASSERT_EQ(run("otf " + path(name) + " --beam-axis +z --tube-grid 3x3 --json " + path(name + ".json")).status,
                  0);
    EXPECT_EQ(json::parse(contentOf(path("v.dcm.json"))).at("otf"),
              json::parse(contentOf(path("v.mha.json"))).at("otf"));
    const ToolOutcome refused = run("phantom " + path("v.xyz") + " --size 16");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.output.find("Use .mha, .mhd, .nii, .nii.gz or .dcm."), std::string::npos) << refused.output;
    EXPECT_FALSE(fs::exists(path("v.xyz")));
}

TEST_F(PhantomCommand, WritesNiftiOfTheSameVoxels) {
    const std::string options = " --size 20x18x22 --spacing 0.4x0.5x0.9 --bits 12 --phases 2";
    for (const char* name : {"v.mha", "v.nii", "v.nii.gz"}) ASSERT_EQ(run("phantom " + path(name) + options).status, 0);
    const auto volumeOf = [&](const std::string& name) {
        json volume = json::parse(run("info " + path(name) + " --phase 1 --json").output).at("volume");
        volume.erase("name");
        // NIfTI-1 holds spacings as float32.
        for (json& mm : volume.at("spacing_mm")) mm = std::round(mm.get<double>() * 1e4);
        return volume;
    };
    EXPECT_EQ(volumeOf("v.nii"), volumeOf("v.mha"));
    EXPECT_EQ(volumeOf("v.nii.gz"), volumeOf("v.mha"));
    EXPECT_EQ(contentOf(path("v.nii")).substr(344, 3), "n+1");
    // Capitals name the same format.
    ASSERT_EQ(run("phantom " + path("V.NII") + options).status, 0);
    EXPECT_EQ(contentOf(path("V.NII")), contentOf(path("v.nii")));
}

TEST_F(PhantomCommand, SameBytesForAnyNumberOfThreads) {
    ASSERT_EQ(run("--threads 1 phantom " + path("one.mha") + " --size 50").status, 0);
    ASSERT_EQ(run("--threads 3 phantom " + path("three.mha") + " --size 50").status, 0);
    ASSERT_EQ(run("phantom " + path("other.mha") + " --size 50 --seed 2").status, 0);
    EXPECT_EQ(contentOf(path("one.mha")), contentOf(path("three.mha")));
    EXPECT_NE(contentOf(path("one.mha")), contentOf(path("other.mha")));
}

TEST_F(PhantomCommand, WrongUsageIsStatusTwoInOneSentence) {
    for (const char* options : {"--size 4", "--size 10x10", "--size axb", "--spacing 0", "--contrast 1,2",
                                "--contrast 1,2,300", "--bits 9", "--scene heart", "--scene empty --front-wall",
                                "--speckle 2", "--speckle nan", "--ramp -1", "--log-compress 0", "--phases 0",
                                "--beam-axis q", "--tube-grid 0x3", "--size 1024 --bits 16 --phases 8", "--nonsense"}) {
        const ToolOutcome outcome = run("phantom " + path("v.mha") + " " + options);
        EXPECT_EQ(outcome.status, 2) << options << ": " << outcome.output;
        EXPECT_FALSE(outcome.output.empty());
        EXPECT_FALSE(fs::exists(path("v.mha"))) << options;
    }
    EXPECT_EQ(run("phantom").status, 2);
}

TEST_F(PhantomCommand, WhatCannotBeWrittenIsStatusFour) {
    EXPECT_EQ(run("phantom " + path("missing/v.mha") + " --size 16").status, 4);
    const ToolOutcome outcome = run("phantom " + path("v.mha") + " --size 16 --truth " + path("missing/t.json"));
    EXPECT_EQ(outcome.status, 4);
    EXPECT_NE(outcome.output.find("missing/t.json"), std::string::npos);
}

TEST_F(PhantomCommand, HelpHasAnExample) {
    const ToolOutcome outcome = run("phantom --help");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.output.find("Example: echolucent-cli phantom"), std::string::npos);
}

}  // namespace
