// Voxels along beams on the command line: phantoms written and read back, options that state the geometry.
#include <nlohmann/json.hpp>

#include "program.h"

namespace echolucent {
namespace {

using nlohmann::json;

class Polar : public testing::Test {
protected:
    json infoOf(const std::string& arguments) const {
        const Outcome outcome = runProgram("info " + arguments + " --json");
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        return json::parse(outcome.output);
    }
    static std::string factOf(const json& info, const std::string& name) {
        for (const json& fact : info.at("facts"))
            if (fact.at("name") == name) return fact.at("value");
        return "none";
    }
    Folder m_folder;
};

TEST_F(Polar, VolusonPhantomIsReadOnTheGridOfItsTruth) {
    const std::string volume = m_folder / "v.vol", truth = m_folder / "t.json";
    const Outcome written =
        runProgram("phantom " + volume + " --size 60x40x30 --spacing 1 --phases 2 --truth " + truth);
    ASSERT_EQ(written.status, 0) << written.errors;
    const json info = infoOf(volume);
    EXPECT_EQ(factOf(info, "polar volume"), "wobbler: 60 samples x 40 lines x 30 planes");
    EXPECT_EQ(info.at("volume").at("phases"), 2);
    const json config = json::parse(contentsOf(truth)).at("config");
    EXPECT_EQ(info.at("volume").at("size"), config.at("size"));
    EXPECT_NEAR(info.at("volume").at("spacing_mm")[0], config.at("spacing_mm")[0], 1e-9);
}

TEST_F(Polar, RawPhantomOpensByItsSideCarAndByOptions) {
    const std::string volume = m_folder / "v.raw";
    for (const std::string kind : {"linear", "convex", "linear-wobbler", "wobbler"}) {
        const Outcome written = runProgram("phantom " + volume + " --polar " + kind + " --size 40x30x20 --spacing 1");
        ASSERT_EQ(written.status, 0) << written.errors;
        EXPECT_EQ(factOf(infoOf(volume), "polar volume"), kind + ": 40 samples x 30 lines x 20 planes");
    }
    const json byOptions = infoOf(volume +
                                  " --raw-size 40x30x20 --raw-polar convex --raw-range 3,0.5 --raw-lines -30,25 "
                                  "--raw-planes -5,6 --raw-radius 41 --conversion-memory 2");
    EXPECT_EQ(factOf(byOptions, "range"), "3 to 22.5 mm from the probe's face, a sample every 0.5 mm");
    EXPECT_EQ(factOf(byOptions, "lines"), "-30 to 25 degrees about an axis 41 mm behind the probe's face");
    EXPECT_EQ(factOf(byOptions, "planes"), "-5 to 6 mm, parallel");
}

TEST_F(Polar, WrongOptionsAreNamed) {
    const std::string volume = m_folder / "v.raw";
    const auto sentenceOf = [&](const std::string& arguments) {
        const Outcome outcome = runProgram(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        return outcome.errors;
    };
    const auto says = [](const std::string& sentence, const std::string& words) {
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    };
    const std::string info = "info " + volume + " --raw-size 40x30x20";
    const std::string range = " --raw-range 0,0.5", lines = " --raw-lines -30,30", planes = " --raw-planes -5,5";
    says(sentenceOf(info + " --raw-polar curved"), "--raw-polar is \"curved\"");
    says(sentenceOf(info + range), "--raw-polar is missing beside other options of polar voxels");
    says(sentenceOf(info + " --raw-polar linear"), "--raw-range is missing beside --raw-polar");
    says(sentenceOf(info + " --raw-polar linear" + range), "--raw-lines is missing");
    says(sentenceOf(info + " --raw-polar linear" + range + lines), "--raw-planes is missing");
    says(sentenceOf(info + " --raw-polar convex" + range + lines + planes), "--raw-radius is missing");
    says(sentenceOf(info + " --raw-polar linear" + range + lines + planes + " --raw-radius 4"),
         "--raw-radius has no meaning where lines and planes are parallel");
    says(sentenceOf(info + " --raw-polar linear" + range + lines + planes + " --raw-spacing 1x1x1"),
         "--raw-spacing has no meaning beside --raw-polar");
    says(sentenceOf(info + " --raw-polar linear" + range + " --raw-lines 3,3" + planes),
         "--raw-lines neither rise nor fall throughout");
    says(sentenceOf(info + " --raw-polar linear --raw-range 0,0" + lines + planes), "--raw-range has a step of 0 mm");
    says(sentenceOf("phantom " + volume), "--polar is missing for a raw file");
    says(sentenceOf("phantom " + (m_folder / "v.mha") + " --polar convex"), "--polar needs a file");
    says(sentenceOf("phantom " + (m_folder / "v.vol") + " --polar convex"), "--polar must be wobbler");
    says(sentenceOf("phantom " + (m_folder / "v.vol") + " --bits 12"),
         "--bits must be 8 for a .vol file. Write more bits to FILE.raw.");
    says(sentenceOf("phantom " + volume + " --polar convex --phases 3"), "--phases must be 1");
    says(sentenceOf("phantom " + volume + " --polar convex --spacing 1x2x1"),
         "--spacing must be one number along beams. Give the mm");
    says(sentenceOf("phantom " + volume + " --polar convex --truth " + volume + ".echolucent.json"), "is named twice");
}

}  // namespace
}  // namespace echolucent
