// --side, and the side that a study opens from, through the real program.
#include <nlohmann/json.hpp>

#include "io/writers/meta_image_writer.h"
#include "otf_of.h"
#include "program.h"
#include "tests/processing/sides/hill.h"

namespace echolucent {
namespace {

using nlohmann::json;

/// A hill that only the side along +y shows. Where the probe was cannot be told.
const std::string& hillFile() {
    static const Folder folder;
    static const std::string path = folder / "hill.mha";
    if (!std::filesystem::exists(path)) {
        const auto written = writeMetaImage(path, {std::make_shared<const Volume>(hillSeenAlong({0, 1, 0}))});
        EXPECT_TRUE(written);
    }
    return path;
}

TEST(Side, WithoutAWordTheOneThatShowsMostIsTakenWithItsFront) {
    const json otf = otfOf(hillFile());
    const json& found = otf["made_of"]["found"];
    EXPECT_EQ(found["sides"]["source"], "found");
    ASSERT_EQ(found["sides"]["list"].size(), 6U);
    const json& taken = *std::ranges::find_if(found["sides"]["list"], [](const json& side) { return side["taken"]; });
    EXPECT_EQ(taken["side"], "side-4");
    for (const json& side : found["sides"]["list"]) EXPECT_LE(side["score"], taken["score"]);
    EXPECT_EQ(otf["view"]["direction_voxel"], json({0.0, 1.0, 0.0}));
    EXPECT_EQ(found["front"]["taken"], true);
    EXPECT_TRUE(otf["view"]["front_bowed"] == true || otf["view"]["near_mm"] > 0.0);
    EXPECT_EQ(otfOf(hillFile(), "--side 4")["otf"], otf["otf"]) << "the same side by its number";
    EXPECT_EQ(otfOf(hillFile(), "--side side-4")["otf"], otf["otf"]) << "and by its word";
}

TEST(Side, AnotherIsTakenWithItsOwnFront) {
    const json otf = otfOf(hillFile(), "--side side-1");
    EXPECT_EQ(otf["view"]["direction_voxel"], json({0.0, 0.0, 1.0}));
    EXPECT_EQ(otf["made_of"]["found"]["sides"]["source"], "person");
    const json probe = otfOf(hillFile(), "--beam-axis +y --side behind");
    EXPECT_EQ(probe["view"]["direction_voxel"], json({0.0, -1.0, 0.0})) << "sides of a beam that was said have names";
    const json cut = otfOf(hillFile(), "--side side-4 --near 5");
    EXPECT_EQ(cut["view"]["near_mm"], 5.0) << "along the side";
    EXPECT_EQ(cut["view"]["direction_voxel"], json({0.0, 1.0, 0.0}));
    // A front or a beam alone belongs to the view along the beam.
    EXPECT_EQ(otfOf(hillFile(), "--near 5")["view"]["direction_voxel"], json({0.0, 0.0, 1.0}));
    EXPECT_TRUE(otfOf(hillFile(), "--beam-axis -x")["made_of"]["found"]["sides"].is_null());
}

TEST(Side, AWordThatNamesNoneIsRefusedWithThoseThatDo) {
    const std::string otf = "otf \"" + hillFile() + "\" --reduction off ";
    const Outcome unknown = runProgram(otf + "--side onto");
    EXPECT_NE(unknown.status, 0);
    EXPECT_EQ(
        unknown.errors.substr(unknown.errors.find("--side")),
        "--side is \"onto\". This scan has the sides side-1, side-2, side-3, side-4, side-5, side-6, or 1 to 6.\n");
    const Outcome turned = runProgram(otf + "--side side-2 --view-azimuth 10");
    EXPECT_NE(turned.status, 0);
    EXPECT_NE(turned.errors.find("--side stands beside a turn of the view"), std::string::npos) << turned.errors;
    EXPECT_NE(runProgram(otf + "--side 7").status, 0);
}

}  // namespace
}  // namespace echolucent
