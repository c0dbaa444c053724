// Frames that vectors order, as nuclear medicine has them: phases of slices, and what is no volume.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Vector {
    std::uint16_t element = 0;  ///< of group 0054
    std::vector<std::uint16_t> values;
};

/// Frames of 2 x 2 pixels, frame i of value 1 + i, 0.8 mm apart.
struct Nuclear {
    std::vector<Vector> vectors;
    DicomBytes gated{}, phases{}, detector{};  ///< items of these sequences, if not empty
    std::string frameTime{}, frameTimes{}, duration{};
    bool pointer = true;
    std::string between = "0.8";
    std::string offsets{};
    int frames = 6;
};

std::string fileOf(const Nuclear& said) {
    DicomBytes file;
    file.text(0x0008, 0x0060, "CS", "NM");
    if (!said.between.empty()) file.text(0x0018, 0x0088, "DS", said.between);
    if (!said.frameTime.empty()) file.text(0x0018, 0x1063, "DS", said.frameTime);
    if (!said.frameTimes.empty()) file.text(0x0018, 0x1065, "DS", said.frameTimes);
    if (!said.duration.empty()) file.text(0x0018, 0x1242, "IS", said.duration);
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
    file.text(0x0028, 0x0008, "IS", std::to_string(said.frames));
    std::vector<std::uint16_t> named;
    for (const Vector& vector : said.vectors) named.insert(named.end(), {0x0054, vector.element});
    if (said.pointer) file.put(0x0028, 0x0009, "AT", bytesFrom<std::uint16_t>(named));
    file.word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 2).text(0x0028, 0x0030, "DS", "0.7\\0.6");
    file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    if (!said.offsets.empty()) file.text(0x3004, 0x000c, "DS", said.offsets);
    if (!said.detector.bytes().empty()) file.sequence(0x0054, 0x0022, {said.detector});
    if (!said.phases.bytes().empty()) file.sequence(0x0054, 0x0032, {said.phases, said.phases});
    if (!said.gated.bytes().empty()) file.sequence(0x0054, 0x0062, {said.gated});
    for (const Vector& vector : said.vectors)
        file.put(0x0054, vector.element, "US", bytesFrom<std::uint16_t>(vector.values));
    std::string pixels;
    for (int frame = 0; frame < said.frames; ++frame) pixels += std::string(4, static_cast<char>(1 + frame));
    return file.put(0x7fe0, 0x0010, "OB", pixels).file("1.2.840.10008.5.1.4.1.1.20");
}

Result<Study> readNuclear(const Nuclear& said, bool asSlices = false) {
    const TemporaryFolder folder;
    return readStudy(folder.write("a.dcm", fileOf(said)), asSlices ? framesAsSlices() : withoutGuess());
}

std::string refusalOf(const Nuclear& said) {
    const auto study = readNuclear(said);
    if (study) return "was read";
    EXPECT_TRUE(study.error().framesCouldBeSlices);
    EXPECT_TRUE(readNuclear(said, true)) << "all frames are slices then";
    return study.error().sentence();
}

/// The frames of each phase in the order of its slices, counted from 1.
std::vector<std::vector<double>> framesOf(const Study& study) {
    std::vector<std::vector<double>> phases;
    for (const auto& phase : study.phases) {
        phases.emplace_back();
        for (std::int64_t i = 0; i < phase->geometry().size[2]; ++i)
            phases.back().push_back(phase->storedValue(static_cast<std::size_t>(4 * i)));
    }
    return phases;
}

constexpr std::uint16_t energyVector = 0x10, detectorVector = 0x20, phaseVector = 0x30, rotationVector = 0x50,
                        intervalVector = 0x60, slotVector = 0x70, sliceVector = 0x80, viewVector = 0x90,
                        timeSliceVector = 0x100;
const Vector twoSlots{slotVector, {1, 1, 1, 2, 2, 2}};
const Vector threeSlices{sliceVector, {1, 2, 3, 1, 2, 3}};
using Frames = std::vector<std::vector<double>>;

TEST(FrameVectors, TimeSlotsArePhasesOfSlices) {
    const auto study = readNuclear({{twoSlots, threeSlices}});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(framesOf(*study), (Frames{{1, 2, 3}, {4, 5, 6}}));
    const VolumeGeometry& geometry = study->phases[1]->geometry();
    EXPECT_LT(length(geometry.spacing - Vec3(0.6, 0.7, 0.8)), 1e-9);
    EXPECT_TRUE(geometry.spacingKnown);
    EXPECT_EQ(sourceOf(*study, "phases"), "(0054,0070) Time Slot Vector");
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
    EXPECT_TRUE(warnsOf(*study, "Frames lie at each of 3 places 2 times: (0054,0070) Time Slot Vector tells 2 phases"));
}

TEST(FrameVectors, ThoseThatOrderNothingAreLeftOutAndNoted) {
    const auto missing = readNuclear({{{sliceVector, {}}}});
    ASSERT_TRUE(missing) << missing.error().sentence();
    EXPECT_EQ(framesOf(*missing), (Frames{{1, 2, 3, 4, 5, 6}}));
    EXPECT_TRUE(warnsOf(*missing, "Frame Increment Pointer names (0054,0080) Slice Vector, which is not in the file"));
    const auto unnamed = readNuclear({.vectors = {{energyVector, {1}}, twoSlots, threeSlices}, .pointer = false});
    ASSERT_TRUE(unnamed) << unnamed.error().sentence();
    EXPECT_EQ(framesOf(*unnamed), (Frames{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_TRUE(warnsOf(*unnamed, "Energy Window Vector is not one number for each of 6 frames; it was left out"));
}

TEST(FrameVectors, SlicesMayBeCountedInSteps) {
    const auto study = readNuclear({{twoSlots, {sliceVector, {1, 3, 5, 5, 3, 1}}}});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(framesOf(*study), (Frames{{1, 2, 3}, {6, 5, 4}}));
    EXPECT_TRUE(warnsOf(*study, "(0054,0080) Slice Vector counts slices in steps of 2"));
}

TEST(FrameVectors, TheOrderInTheFileMeansNothing) {
    const auto study = readNuclear({{{slotVector, {2, 1, 2, 1, 2, 1}}, {sliceVector, {3, 3, 2, 2, 1, 1}}}});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(framesOf(*study), (Frames{{6, 4, 2}, {5, 3, 1}}));
    // Slices that run against the normal are turned, in all phases.
    const auto backwards = readNuclear({.vectors = {twoSlots, threeSlices}, .between = "-0.8"});
    ASSERT_TRUE(backwards) << backwards.error().sentence();
    EXPECT_EQ(framesOf(*backwards), (Frames{{3, 2, 1}, {6, 5, 4}}));
    // One time, other slices first.
    const auto one = readNuclear({{{slotVector, {1, 1, 1, 1, 1, 1}}, {sliceVector, {6, 5, 4, 3, 2, 1}}}});
    ASSERT_TRUE(one) << one.error().sentence();
    EXPECT_EQ(framesOf(*one), (Frames{{6, 5, 4, 3, 2, 1}}));
    // Without a pointer the vectors that are there count.
    const auto unnamed = readNuclear({.vectors = {twoSlots, threeSlices}, .pointer = false});
    ASSERT_TRUE(unnamed) << unnamed.error().sentence();
    EXPECT_EQ(framesOf(*unnamed), (Frames{{1, 2, 3}, {4, 5, 6}}));
}

TEST(FrameVectors, OffsetsGoWithTheFramesOfEachPhase) {
    const Nuclear good{.vectors = {twoSlots, threeSlices}, .between = "", .offsets = "4\\2\\0\\4\\2\\0"};
    const auto study = readNuclear(good);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(framesOf(*study), (Frames{{3, 2, 1}, {6, 5, 4}}));
    EXPECT_DOUBLE_EQ(study->phases[0]->geometry().spacing[2], 2);
    Nuclear bad = good;
    bad.offsets = "4\\2\\0\\4\\3\\0";
    const auto refused = readNuclear(bad);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("Grid Frame Offset Vector changes from phase to phase"));
}

TEST(FrameVectors, TimesOfPhasesAreReadWhereTheyStand) {
    const auto secondsOf = [](const Nuclear& said) {
        const auto study = readNuclear(said);
        EXPECT_TRUE(study) << study.error().sentence();
        return study ? study->phaseTimes.meanSeconds.value_or(0) : -1;
    };
    Nuclear said{{twoSlots, threeSlices}};
    said.frameTime = "50";
    EXPECT_DOUBLE_EQ(secondsOf(said), 0.05);
    DicomBytes data;
    data.text(0x0018, 0x1063, "DS", "60");
    said.gated.sequence(0x0054, 0x0063, {data});
    EXPECT_DOUBLE_EQ(secondsOf(said), 0.06) << "the gated study's own";
    said.gated = {};
    said.frameTime = "";
    said.duration = "20000";
    EXPECT_DOUBLE_EQ(secondsOf(said), 20);
    said.gated.text(0x0018, 0x1060, "DS", "1");
    EXPECT_DOUBLE_EQ(secondsOf(said), 0) << "the duration of a whole gated study";
    said = {{{timeSliceVector, {1, 1, 1, 2, 2, 2}}, threeSlices}};
    said.phases.text(0x0018, 0x1242, "IS", "5000").text(0x0054, 0x0038, "IS", "1000");
    EXPECT_DOUBLE_EQ(secondsOf(said), 6);
}

TEST(FrameVectors, UnevenTimesAreKept) {
    Nuclear said{.vectors = {{phaseVector, {1, 1, 1, 1, 2, 2, 2, 2}},
                             {timeSliceVector, {1, 1, 2, 2, 1, 1, 2, 2}},
                             {sliceVector, {1, 2, 1, 2, 1, 2, 1, 2}}},
                 .frames = 8};
    said.phases.text(0x0018, 0x1242, "IS", "2000").text(0x0054, 0x0036, "IS", "500");
    const auto study = readNuclear(said);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(framesOf(*study), (Frames{{1, 2}, {3, 4}, {5, 6}, {7, 8}}));
    EXPECT_EQ(study->phaseTimes.starts, (std::vector<double>{0, 2, 4.5, 6.5}));
    EXPECT_EQ(sourceOf(*study, "time between phases"),
              "(0054,0032) Phase Information; phases by (0054,0030) Phase Vector, (0054,0100) Time Slice Vector");
    said.phases = {};
    said.frameTimes = "0\\1000\\2000\\4000";
    const auto vector = readNuclear(said);
    ASSERT_TRUE(vector) << vector.error().sentence();
    EXPECT_EQ(vector->phaseTimes.starts, (std::vector<double>{0, 1, 3, 7}));
}

TEST(FrameVectors, TheDetectorStatesThePlaceInThePatient) {
    Nuclear said{{twoSlots, threeSlices}};
    said.detector.text(0x0020, 0x0032, "DS", "5\\6\\7").text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\0\\-1");
    const auto study = readNuclear(said);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().origin, Vec3(5, 6, 7));
    EXPECT_TRUE(study->phases[0]->geometry().patientFrameKnown);
    EXPECT_EQ(study->phases[0]->geometry().direction(1, 2), 1);
}

TEST(FrameVectors, APlaceOfTheDetectorThatMakesNoSenseIsLeftOut) {
    Nuclear said{{twoSlots, threeSlices}};
    said.detector.text(0x0020, 0x0032, "DS", "0\\0").text(0x0020, 0x0037, "DS", "0\\0\\0\\0\\0\\0");
    const auto study = readNuclear(said);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().patientFrameKnown);
    EXPECT_EQ(study->phases[0]->geometry().origin, Vec3(0, 0, 0));
    EXPECT_TRUE(warnsOf(*study, "(0020,0032) Image Position (Patient) in (0054,0022) Detector Information is no"));
    EXPECT_TRUE(warnsOf(*study, "(0020,0037) Image Orientation (Patient) in (0054,0022) Detector Information is no"));
}

TEST(FrameVectors, FramesThatAreNoVolumeAreRefusedByWhatTheyAre) {
    const std::vector<std::pair<std::uint16_t, std::string>> others{
        {energyVector, "has frames of 2 energy windows. Export one energy window."},
        {detectorVector, "has frames of 2 detectors"},
        {rotationVector, "has frames of 2 rotations. These are projections"},
        {intervalVector, "has frames of 2 R-R intervals"},
        {viewVector, "has frames of 2 angular views. These are projections, not a volume"}};
    for (const auto& [vector, words] : others) {
        EXPECT_THAT(refusalOf({{{vector, {1, 1, 1, 2, 2, 2}}, threeSlices}}), HasSubstr(words));
        EXPECT_TRUE(readNuclear({{{vector, {1, 1, 1, 1, 1, 1}}, twoSlots, threeSlices}})) << "of one kind";
    }
    EXPECT_THAT(refusalOf({{{slotVector, {1, 2, 3, 4, 5, 6}}}}),
                HasSubstr("is a 2D cine: its 6 frames show one plane over time ((0054,0070) Time Slot Vector)"));
    EXPECT_THAT(refusalOf({{{slotVector, {1, 2, 3, 4, 5, 6}}, {sliceVector, {1, 1, 1, 1, 1, 1}}}}),
                HasSubstr("one plane over time"));
}

TEST(FrameVectors, VectorsThatContradictEachOtherAreRefused) {
    EXPECT_THAT(refusalOf({{{slotVector, {1, 1, 1, 2, 2}}, threeSlices}}),
                HasSubstr("(0054,0070) Time Slot Vector is not one number for each of 6 frames"));
    EXPECT_THAT(refusalOf({{twoSlots, {sliceVector, {1, 2, 2, 1, 2, 3}}}}),
                HasSubstr("puts frames 2 and 3 at one place and time"));
    EXPECT_THAT(refusalOf({{threeSlices}}), HasSubstr("puts frames 1 and 4 at one place and time"));
    EXPECT_THAT(refusalOf({{twoSlots, {sliceVector, {1, 2, 4, 1, 2, 4}}}}),
                HasSubstr("counts 3 slices from 1 to 4: some are missing"));
    EXPECT_THAT(refusalOf({{{slotVector, {1, 1, 1, 2, 2, 3}}, threeSlices}}),
                HasSubstr("gives phase 2 other slices than the first"));
}

}  // namespace
}  // namespace echolucent
