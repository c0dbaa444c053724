// --near auto through the real program.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "otf_of.h"
#include "program.h"

namespace echolucent {
namespace {

using nlohmann::json;

std::string walledFile() {
    return phantomFile("walled.mha", "--scene shapes --size 110x100x120 --seed 5 --front-wall");
}

TEST(NearAuto, SaysWhatItSuggestsAndReportsItInTheJson) {
    const Outcome outcome =
        runProgram("otf \"" + walledFile() + "\" --beam-axis +z --near auto --reduction off --json -");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const json otf = json::parse(outcome.output);
    const double nearMm = otf["view"]["near_mm"];
    // The wall is up to a fifth of 60 mm thick; the shapes lie behind.
    EXPECT_GT(nearMm, 6.0);
    EXPECT_LT(nearMm, 20.0);
    double said = 0;
    int inFluid = 0, tubes = 0;
    const std::size_t sentence = outcome.errors.find("A wall stands");
    ASSERT_NE(sentence, std::string::npos) << outcome.errors;
    ASSERT_EQ(std::sscanf(outcome.errors.c_str() + sentence,
                          "A wall stands before the fluid: behind a front at %lf mm %d of %d tube cores are in fluid.",
                          &said, &inFluid, &tubes),
              3)
        << outcome.errors;
    EXPECT_NEAR(said, nearMm, 0.05 + 1e-9);
    EXPECT_EQ(otf["made_of"]["found"]["front"]["taken"], true);
    EXPECT_GT(inFluid, 0.3 * tubes) << "the others meet no shape behind the wall";
    // The result is the same as asking for that cut.
    const json asked = otfOf(walledFile(), "--near " + json(nearMm).dump());
    EXPECT_EQ(asked["otf"], otf["otf"]);
    for (const json& tube : otf["tubes"])
        if (!tube["entry_voxel"].is_null()) {
            EXPECT_NEAR(tube["entry_voxel"][2].get<double>(), nearMm / 0.5 - 0.5, 1e-9);
        }
}

TEST(NearAuto, SaysSoWhereNoneIsNeededOrNoneCanBeFound) {
    const Outcome unneeded =
        runProgram("otf \"" + shapesFile() + "\" --beam-axis +z --near auto --reduction off --json -");
    ASSERT_EQ(unneeded.status, 0) << unneeded.errors;
    EXPECT_NE(unneeded.errors.find("The data begin in fluid ("), std::string::npos) << unneeded.errors;
    const json uncut = json::parse(unneeded.output);
    EXPECT_EQ(uncut["view"]["near_mm"], 0.0);
    EXPECT_EQ(uncut["made_of"]["found"]["front"]["answer"], "fluid at the front");
    EXPECT_EQ(uncut["made_of"]["found"]["front"]["taken"], false);
    const std::string empty = phantomFile("empty.mha", "--scene empty --size 64x64x64 --seed 5");
    const Outcome none = runProgram("otf \"" + empty + "\" --beam-axis +z --near auto --reduction off --json -");
    ASSERT_EQ(none.status, 0) << none.errors;
    EXPECT_NE(none.errors.find("No fluid was found ("), std::string::npos) << none.errors;
    EXPECT_NE(none.errors.find("\nNo surface found: the initial function is used.\n"), std::string::npos)
        << none.errors;
    EXPECT_EQ(json::parse(none.output)["view"]["near_mm"], 0.0);
}

TEST(NearAuto, WithoutNearASureFrontIsTakenAndAnotherIsNot) {
    // A sure one, bowed: it follows the wall, which is rough.
    const json found = otfOf(walledFile(), "--beam-axis +z");
    const json& front = found["made_of"]["found"]["front"];
    ASSERT_EQ(front["answer"], "wall before fluid");
    ASSERT_EQ(front["sure"], true);
    EXPECT_EQ(front["taken"], true);
    EXPECT_EQ(front["bowed"], true);
    EXPECT_EQ(found["view"]["front_bowed"], true);
    EXPECT_EQ(found["view"]["near_mm"], 0.0) << "there is no flat front beside it";
    const json none = otfOf(walledFile(), "--beam-axis +z --near 0");
    EXPECT_EQ(none["view"]["near_mm"], 0.0);
    EXPECT_TRUE(none["made_of"]["found"]["front"].is_null()) << "it is not looked for";
    EXPECT_EQ(none["view"]["front_bowed"], false);
    EXPECT_TRUE(none["otf"] != found["otf"]);
}

TEST(NearAuto, WorksForThePictureToo) {
    const Folder folder;
    const Outcome outcome =
        runProgram("render \"" + walledFile() + "\" --beam-axis +z --near auto --otf adaptive --size 64x64 -o \"" +
                   folder / "cut.png" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.errors.find("A wall stands before the fluid: behind a front at "), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder / "cut.png"));
}

TEST(LongNearAuto, CutsWhereverAVolumeIsLookedAt) {
    const json cut = otfOf(walledFile(), "--beam-axis +z --near auto");
    const Outcome sweep =
        runProgram("sweep \"" + walledFile() +
                   "\" --beam-axis +z --near auto --reduction off --from 0 --to 1 --smoothing none --csv -");
    ASSERT_EQ(sweep.status, 0) << sweep.errors;
    EXPECT_NE(sweep.errors.find("A wall stands before the fluid: behind a front at "), std::string::npos);
    // The first frame is the cut view: its last opacity stands at the end of the first row.
    const std::string row = sweep.output.substr(sweep.output.find('\n') + 1);
    const std::string firstRow = row.substr(0, row.find('\n'));
    EXPECT_DOUBLE_EQ(std::stod(firstRow.substr(firstRow.rfind(',') + 1)), cut["otf"]["opacity"].back().get<double>());
    const Outcome bench = runProgram("bench otf \"" + walledFile() + "\" --beam-axis +z --near auto --runs 1");
    ASSERT_EQ(bench.status, 0) << bench.errors;
    EXPECT_EQ(bench.errors.rfind("A wall stands before the fluid: behind a front at ", 0), 0u) << bench.errors;
}

TEST(NearAuto, RefusesWhatIsNeitherANumberNorAuto) {
    for (const char* near : {"nonsense", "automatic", "AUTO", "nan", "inf", "1x2", "\"\""}) {
        const Outcome outcome = runProgram("otf \"" + shapesFile() + "\" --near " + near);
        EXPECT_EQ(outcome.status, 2) << near;
        EXPECT_EQ(outcome.output, "") << near;
        EXPECT_NE(outcome.errors.find("--near"), std::string::npos) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    }
    const Outcome phantom =
        runProgram("phantom \"" + testing::TempDir() + "none.mha\" --truth - --beam-axis +z --near auto");
    EXPECT_EQ(phantom.status, 2);
    EXPECT_NE(phantom.errors.find("--near"), std::string::npos) << phantom.errors;
}

}  // namespace
}  // namespace echolucent
