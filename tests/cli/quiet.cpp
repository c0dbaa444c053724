// The real program's `quiet`, and --reduction of `otf`, `study contrast` and `study quiet`.
#include <algorithm>

#include "io/study/study.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/cli/otf_of.h"
#include "tests/cli/program.h"

namespace echolucent {
namespace {

TEST(QuietCommand, WritesTheQuietVoxelsUncompressed) {
    const Folder folder;
    const std::string path = folder / "quiet.mha";
    const Outcome outcome = runProgram("quiet \"" + shapesFile() + "\" --reduction light -o \"" + path + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(contentsOf(path).find("CompressedData = False"), std::string::npos);
    const auto raw = readStudy(shapesFile()), quiet = readStudy(path);
    ASSERT_TRUE(raw && quiet);
    EXPECT_EQ(quiet->phases[0]->voxels(), quietVolume(*raw->phases[0], SpeckleReduction::light)->voxels());
    EXPECT_EQ(quiet->phases[0]->geometry().spacing, raw->phases[0]->geometry().spacing);
}

TEST(QuietCommand, WithoutANameTakesTheDefaultAndOffCopies) {
    const Folder folder;
    ASSERT_EQ(runProgram("quiet \"" + shapesFile() + "\" -o \"" + folder / "quiet.mha" + "\"").status, 0);
    ASSERT_EQ(runProgram("quiet \"" + shapesFile() + "\" --reduction off -o \"" + folder / "off.mha" + "\"").status, 0);
    const auto raw = readStudy(shapesFile()), quiet = readStudy(folder / "quiet.mha"),
               off = readStudy(folder / "off.mha");
    ASSERT_TRUE(raw && quiet && off);
    EXPECT_EQ(quiet->phases[0]->voxels(), quietVolume(*raw->phases[0], defaultSpeckleReduction)->voxels());
    EXPECT_EQ(off->phases[0]->voxels(), raw->phases[0]->voxels());
}

TEST(QuietCommand, RefusesWhatMakesNoSense) {
    const Folder folder;
    const std::string out = " -o \"" + folder / "quiet.mha" + "\"";
    const Outcome name = runProgram("quiet \"" + shapesFile() + "\" --reduction loud" + out);
    EXPECT_EQ(name.status, 2);
    EXPECT_NE(name.errors.find("Use off, light, medium or strong."), std::string::npos) << name.errors;
    EXPECT_EQ(runProgram("quiet \"" + shapesFile() + "\" --phase 1" + out).status, 2);
    EXPECT_EQ(runProgram("quiet \"" + shapesFile() + "\" -o \"" + shapesFile() + "\"").status, 2);
    EXPECT_EQ(runProgram("quiet nothing.mha" + out).status, 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "quiet.mha"));
}

TEST(QuietCommand, TheReportOfOtfNamesTheReduction) {
    const auto off = otfOf(shapesFile(), "--reduction off");
    auto medium = otfOf(shapesFile(), "--reduction medium");
    EXPECT_EQ(off["reduction"], "off");
    EXPECT_EQ(off["speckle_left"], 1.0);
    EXPECT_EQ(medium["reduction"], "medium");
    EXPECT_LT(medium["speckle_left"], 0.6);
    EXPECT_FALSE(otfOf(shapesFile(), "--reduction medium --reading published").contains("speckle_left"))
        << "detection by variance measures no speckle";
    for (auto& tube : medium["tubes"]) tube.erase("quiet");
    EXPECT_TRUE(off["tubes"] == medium["tubes"]) << "surfaces are those of the voxels as they were read";
    EXPECT_NE(off["otf"], medium["otf"]);
}

TEST(LongQuietCommand, TheStudyHasARowForEveryFilter) {
    const Folder folder;
    const Outcome outcome =
        runProgram("study quiet --size 48 --seeds 3 --timed-edge 16 --repeats 1 -o \"" + folder / "q" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string csv = contentsOf(folder / "q/quiet.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
    EXPECT_TRUE(contentsOf(folder / "q/quiet.html").starts_with("<!DOCTYPE html>"));
    EXPECT_NE(outcome.output.find("joint bilateral, two passes"), std::string::npos);
}

}  // namespace
}  // namespace echolucent
