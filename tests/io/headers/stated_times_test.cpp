// Times of phases that text headers state: index values, labels, time stamps, a direction through time, a spacing.
#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace echolucent {
namespace {

/// Four phases of 1 x 1 x 2 voxels, the phase as the last axis.
Result<Study> movingNrrd(const std::string& fields) {
    const TemporaryFolder folder;
    return readStudy(folder.write("v.nrrd", "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 1 1 2 4\n" + fields +
                                                "encoding: raw\n\nabcdefgh"),
                     withoutGuess());
}
/// The same, the phase as the first axis.
Result<Study> fastestNrrd(const std::string& fields) {
    const TemporaryFolder folder;
    return readStudy(folder.write("v.nrrd", "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 4 1 1 2\n" + fields +
                                                "encoding: raw\n\nabcdefgh"),
                     withoutGuess());
}
Result<Study> movingMetaImage(const std::string& keys) {
    const TemporaryFolder folder;
    return readStudy(
        folder.write("v.mha", "ObjectType = Image\nNDims = 4\nDimSize = 1 1 2 4\nElementType = MET_UCHAR\n" + keys +
                                  "ElementDataFile = LOCAL\nabcdefgh"),
        withoutGuess());
}

void expectEvery(const Result<Study>& study, double seconds, const std::string& what) {
    ASSERT_TRUE(study) << what << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 4U);
    ASSERT_TRUE(study->phaseTimes.meanSeconds) << what;
    EXPECT_NEAR(*study->phaseTimes.meanSeconds, seconds, 1e-12) << what;
    EXPECT_TRUE(study->phaseTimes.starts.empty()) << what;
    EXPECT_FALSE(warnsOf(*study, "uneven")) << what;
}
void expectUneven(const Result<Study>& study, const std::vector<double>& starts, const std::string& what) {
    ASSERT_TRUE(study) << what << study.error().sentence();
    ASSERT_EQ(study->phaseTimes.starts.size(), starts.size()) << what;
    for (std::size_t i = 0; i < starts.size(); ++i) EXPECT_NEAR(study->phaseTimes.starts[i], starts[i], 1e-12) << what;
    EXPECT_TRUE(warnsOf(*study, "The times between phases are uneven")) << what;
}
void expectNoTimes(const Result<Study>& study, const std::string& words) {
    ASSERT_TRUE(study) << words << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 4U);
    EXPECT_EQ(study->phaseTimes, PhaseTimes()) << words;
    EXPECT_EQ(warnsOf(*study, "the time between phases is unknown"), !words.empty()) << words;
    EXPECT_TRUE(words.empty() || warnsOf(*study, words)) << words;
}

const std::string listAxis =
    "kinds: domain domain domain list\nspace: left-posterior-superior\n"
    "space directions: (1,0,0) (0,1,0) (0,0,1) none\n";

TEST(StatedTimes, OfASequenceAreItsIndexValues) {
    const std::string values = "axis 3 index type:=numeric\naxis 3 index values:=0 0.142 0.284 0.426\n";
    const std::string time = "labels: \"\" \"\" \"\" \"time\"\n";
    expectEvery(movingNrrd(listAxis + time + "units: \"\" \"\" \"\" \"s\"\n" + values), 0.142, "s");
    expectEvery(movingNrrd(listAxis + time + "units: \"\" \"\" \"\" \"ms\"\n" + values), 0.000142, "ms");
    expectEvery(movingNrrd(listAxis + time + "units: mm mm mm min\n" + values), 0.142 * 60, "min");
    expectEvery(movingNrrd(listAxis + time + values), 0.142, "named time");
    expectEvery(movingNrrd(listAxis + time + "axis 0 index type:=numeric\naxis 0 index values:=1 2 3 4\n"), 1,
                "an axis that was moved");
    expectEvery(movingNrrd(listAxis + "axis 3 index values:=0,5 1,0 1,5 2,0\n"), 0.5, "decimal commas");
    expectEvery(fastestNrrd("kinds: list domain domain domain\nlabels: \"time\" \"\" \"\" \"\"\nunits: \"s\" \"\" \"\" "
                            "\"\"\naxis 0 index type:=numeric\naxis 0 index values:=2.000 2.040 2.080 2.120\n"),
                0.04, "first axis");
    expectUneven(movingNrrd(listAxis + time + "units: \"\" \"\" \"\" \"ms\"\naxis 3 index values:=10 30 90 130\n"),
                 {0, 0.02, 0.08, 0.12}, "uneven");
}

TEST(StatedTimes, ThatAreNoTimesAreSaidOnce) {
    const std::string values = "axis 3 index type:=numeric\naxis 3 index values:=";
    expectNoTimes(
        movingNrrd(listAxis + "labels: \"\" \"\" \"\" \"time\"\nunits: \"\" \"\" \"\" \"s\"\naxis 3 index type:=text\n"
                              "axis 3 index values:=one two three four\n"),
        "axis 3 index values are texts");
    expectNoTimes(movingNrrd(listAxis + "axis 3 index type:=text\naxis 3 index values:=1 2 3 5\nspacings: 1 1 1 5\n"),
                  "axis 3 index values are texts");
    expectNoTimes(movingNrrd(listAxis + "units: \"\" \"\" \"\" \"%\"\n" + values + "0 10 20 30\n"),
                  "\"%\", which is not a known");
    expectNoTimes(movingNrrd(listAxis + "labels: \"\" \"\" \"\" \"angle\"\n" + values + "0 10 20 30\n"),
                  "called \"angle\"");
    expectNoTimes(movingNrrd(listAxis + "units: \"\" \"\" \"\" \"s\"\n" + values + "0 2 1 3\n"), "do not rise");
    expectNoTimes(movingNrrd(listAxis + "units: \"\" \"\" \"\" \"s\"\n" + values + "0 1 2\n"), "3 times for 4 phases");
    expectNoTimes(movingNrrd(listAxis + "units: \"\" \"\" \"\" \"s\"\n" + values + "0 1 nan 3\n"), "do not rise");
    expectNoTimes(movingNrrd(listAxis + values + "0 1 2 3\n"), "");
    expectNoTimes(movingNrrd("spacings: 1 1 1 40\nunits: \"mm\" \"mm\" \"mm\" \"furlong\"\n"),
                  "\"furlong\", which is not a known time");
    expectNoTimes(movingNrrd("spacings: 1 1 1 40\nunits: mm mm mm mm\n"), "\"mm\", which is not a known time");
}

TEST(StatedTimes, OfAMultiVolumeAreItsLabelsIfTheyAreTimes) {
    const auto labels = [](const std::string& values, const std::string& tag, const std::string& unit) {
        return movingNrrd(listAxis + "MultiVolume.NumberOfFrames:=4\nMultiVolume.FrameLabels:=" + values +
                          "\nMultiVolume.FrameIdentifyingDICOMTagName:=" + tag +
                          "\nMultiVolume.FrameIdentifyingDICOMTagUnits:=" + unit + "\n");
    };
    expectEvery(labels("0,40,80,120", "TriggerTime", "ms"), 0.04, "trigger");
    expectEvery(labels("0,40,80,120", "TriggerTime", ""), 0.04, "trigger without a unit");
    expectEvery(labels("0, 2.5, 5, 7.5", "AcquisitionTime", "s"), 2.5, "acquisition");
    expectUneven(labels("100,140,200,240", "ContentTime", "ms"), {0, 0.04, 0.1, 0.14}, "uneven");
    expectNoTimes(labels("5,10,15,20", "FlipAngle", "degrees"), "phases apart by \"FlipAngle\"");
    expectNoTimes(labels("5,10,15,20", "EchoTime", "ms"), "phases apart by \"EchoTime\"");
    expectNoTimes(labels("0,40,80", "TriggerTime", "ms"), "3 times for 4 phases");
    expectNoTimes(labels("0,40,80,120", "AcquisitionTime", ""), "has no unit");
    expectNoTimes(labels("a,b,c,d", "TriggerTime", "ms"), "no list of numbers");
    expectNoTimes(labels("0,1,2,3", "", ""), "");
}

std::string stamps(const std::vector<std::string>& times, const std::string& equals) {
    std::string keys;
    for (std::size_t i = 0; i < times.size(); ++i)
        keys += "Seq_Frame000" + std::to_string(i) + "_Timestamp" + equals + times[i] + "\nSeq_Frame000" +
                std::to_string(i) + "_ImageStatus" + equals + "OK\n";
    return keys;
}

TEST(StatedTimes, OfFramesOfPlusAreTheirTimeStamps) {
    const std::string spacing = "ElementSpacing = 0.6 0.7 0.8 1\nKinds = domain domain domain list\n";
    const std::vector<std::string> even{"50.000", "50.125", "50.250", "50.375"};
    expectEvery(movingMetaImage(spacing + stamps(even, " = ")), 0.125, "MetaImage");
    expectEvery(movingMetaImage(stamps(even, " = ")), 0.125, "without a spacing");
    expectEvery(movingMetaImage("ElementSpacing = 1 1 1 9\n" + stamps(even, " = ")), 0.125, "beside a fourth spacing");
    expectEvery(movingNrrd(listAxis + stamps(even, ":=")), 0.125, "NRRD");
    expectUneven(movingMetaImage(spacing + stamps({"50", "50.1", "50.3", "50.4"}, " = ")), {0, 0.1, 0.3, 0.4},
                 "uneven");
    expectNoTimes(movingMetaImage(spacing + stamps({"0", "0", "0", "0"}, " = ")), "do not rise");
    expectNoTimes(movingMetaImage(spacing + stamps({"1", "2", "x", "4"}, " = ")), "do not rise");
    expectNoTimes(movingMetaImage(spacing + stamps({"1", "2", "3"}, " = ")), "3 times for 4 phases");
    expectEvery(movingMetaImage("ElementSpacing = 1 1 1 0.04\n"), 0.04, "a fourth spacing");
    expectNoTimes(movingMetaImage(spacing), "");
}

TEST(StatedTimes, OfAFourthDirectionAreItsLength) {
    const std::string space =
        "space: right-anterior-superior-time\nspace directions: (-0.5,0,0,0) (0,-0.6,0,0) "
        "(0,0,0.7,0) (0,0,0,40)\nspace origin: (1,2,3,0)\n";
    const auto study = movingNrrd(space + "space units: \"mm\" \"mm\" \"mm\" \"ms\"\n");
    expectEvery(study, 0.04, "ms");
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.5, 0.6, 0.7));
    EXPECT_EQ(study->phases[0]->geometry().origin, Vec3(-1, -2, 3));
    EXPECT_EQ(study->phases[1]->storedValue(0), 'c');
    expectEvery(movingNrrd(space), 40, "assumed");
    expectEvery(
        movingNrrd("space: LPST\nspace directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,0.5)\nspace units: mm mm mm "
                   "s\n"),
        0.5, "LPST");
    expectEvery(fastestNrrd("space dimension: 4\nspace directions: (0,0,0,0.25) (1,0,0,0) (0,1,0,0) (0,0,1,0)\n"), 0.25,
                "first axis");
    expectNoTimes(movingNrrd("space: LPST\nspace directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,-0.5)\n"),
                  "leads back in time");
    expectNoTimes(movingNrrd("space: LPST\nspace directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,1)\n"), "");
}

TEST(StatedTimes, OfASpacingCountWithTheirUnit) {
    const std::string matlab =
        "kinds: time domain domain domain\nspace: left-posterior-superior\n"
        "space directions: none (0.3,0,0) (0,0.35,0) (0,0,0.4)\n"
        "units: ms mm mm mm\nspacings: 40 nan nan nan\n";
    const auto study = fastestNrrd(matlab);
    expectEvery(study, 0.04, "unquoted");
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.3, 0.35, 0.4));
    EXPECT_TRUE(study->phases[0]->geometry().spacingKnown);
    expectEvery(movingNrrd("spacings: 1 1 1 40\nunits: mm mm mm us\n"), 4e-5, "us");
    expectEvery(
        movingNrrd("axis mins: 0 0 0 0\naxis maxs: 1 1 2 120\ncenterings: cell cell cell node\nunits: mm mm mm ms\n"),
        0.04, "ends of the axis");
    expectNoTimes(movingNrrd("spacings: 1 1 1 1\nunits: mm mm mm\n"), "");
}

TEST(StatedTimes, OfFramesTakenAsSlicesAreNoTimesOfPhases) {
    const TemporaryFolder folder;
    const auto study =
        readStudy(folder.write("v.mha", "NDims = 4\nDimSize = 2 1 1 4\nElementType = MET_UCHAR\n" +
                                            stamps({"1", "2", "5", "6"}, " = ") + "ElementDataFile = LOCAL\nabcdefgh"),
                  framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 1U);
    EXPECT_EQ(study->phaseTimes, PhaseTimes());
    EXPECT_FALSE(warnsOf(*study, "uneven"));
}

}  // namespace
}  // namespace echolucent
