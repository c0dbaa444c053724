// Which frames of an Enhanced US Volume speak for the volume: those that are left out say nothing of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

const std::string enhancedUs = "1.2.840.10008.5.1.4.1.1.6.2";

DicomBytes& doubles(DicomBytes& bytes, std::uint16_t group, std::uint16_t element, const std::vector<double>& values) {
    return bytes.put(group, element, "FD", bytesFrom<double>(values));
}

/// What the groups of one frame say.
struct OneFrame {
    double depth = 0;  ///< z of its position
    std::uint16_t grey = 1;
    std::string type = "TISSUE_INTENSITY";
    std::string window{};  ///< centre and width of its own; none where it is empty
    std::string slope{};   ///< of its own; none where it is empty
    std::optional<double> seconds{};
};

DicomBytes groupsOf(const OneFrame& frame) {
    DicomBytes type, position, time, window, slope, groups;
    type.text(0x0018, 0x9808, "CS", frame.type);
    doubles(position, 0x0020, 0x9301, {0, 0, frame.depth});
    if (frame.seconds) doubles(time, 0x0020, 0x930d, {*frame.seconds});
    window.text(0x0028, 0x1050, "DS", frame.window).text(0x0028, 0x1051, "DS", frame.window);
    slope.text(0x0028, 0x1052, "DS", "0").text(0x0028, 0x1053, "DS", frame.slope);
    groups.sequence(0x0018, 0x9807, {type}).sequence(0x0020, 0x930e, {position});
    if (frame.seconds) groups.sequence(0x0020, 0x9310, {time});
    if (!frame.window.empty()) groups.sequence(0x0028, 0x9132, {window});
    if (!frame.slope.empty()) groups.sequence(0x0028, 0x9145, {slope});
    return groups;
}

/// Frames of 2 x 2 equal pixels of 12 bits.
std::string fileOf(const std::vector<OneFrame>& frames, bool pixelSize = true, bool apex = false) {
    DicomBytes file, shared, orientation, measures;
    doubles(orientation, 0x0020, 0x9302, {1, 0, 0, 0, 1, 0});
    measures.text(0x0028, 0x0030, "DS", "0.5\\0.25");
    shared.sequence(0x0020, 0x930f, {orientation});
    if (pixelSize) shared.sequence(0x0028, 0x9110, {measures});
    if (apex) {
        file.text(0x0020, 0x9307, "CS", "APEX");
        doubles(file, 0x0020, 0x9308, {30, 0, 0});
    }
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
    file.text(0x0028, 0x0008, "IS", std::to_string(frames.size())).word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 2);
    file.word(0x0028, 0x0100, 16).word(0x0028, 0x0101, 12).word(0x0028, 0x0102, 11).word(0x0028, 0x0103, 0);
    std::vector<DicomBytes> groups;
    std::vector<std::uint16_t> pixels;
    for (const OneFrame& frame : frames) {
        groups.push_back(groupsOf(frame));
        pixels.insert(pixels.end(), 4, frame.grey);
    }
    file.sequence(0x5200, 0x9229, {shared}).sequence(0x5200, 0x9230, groups);
    return file.put(0x7fe0, 0x0010, "OW", bytesFrom<std::uint16_t>(pixels)).file(enhancedUs);
}

Result<Study> readFrames(const std::string& bytes, bool asSlices = false) {
    const TemporaryFolder folder;
    ReadOptions options = withoutGuess();
    options.framesAsSlices = asSlices;
    return readStudy(folder.write("v.dcm", bytes), options);
}

TEST(FramesShown, FlowGivesTissueNeitherItsWhiteNorItsSlope) {
    const auto study = readFrames(fileOf({{0, 3000, "FLOW_VELOCITY", "4000", "10"},
                                          {0, 100, "TISSUE_INTENSITY", "120"},
                                          {1, 150, "TISSUE_INTENSITY", "120"}}));
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases[0];
    EXPECT_EQ(volume.typeName(), "uint16");
    EXPECT_EQ(storedValues(volume), (std::vector<double>{100, 100, 100, 100, 150, 150, 150, 150}));
    EXPECT_EQ(volume.whiteLevel(), 180) << "centre 120, width 120";
    EXPECT_EQ(factOf(*study, "rescaling"), "none");
    for (const ImportFact& fact : study->facts)
        if (fact.name == "white level") {
            EXPECT_THAT(fact.source, HasSubstr(", frame 2"));
        }
}

TEST(FramesShown, TissueKeepsItsOwnSlope) {
    const auto study = readFrames(fileOf({{0, 3, "FLOW_VELOCITY", "", "100"},
                                          {0, 100, "TISSUE_INTENSITY", "", "0.5"},
                                          {1, 150, "TISSUE_INTENSITY", "", "0.5"}}));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(0), 50);
    EXPECT_EQ(study->phases[0]->storedValue(7), 75);
    EXPECT_EQ(factOf(*study, "rescaling"), "slope 0.5, intercept 0") << "the same in all frames that are shown";
}

TEST(FramesShown, FlowIsNoSliceEither) {
    const auto at = [](double seconds, const char* type, std::uint16_t grey) {
        return OneFrame{0, grey, type, "", "", seconds};
    };
    const std::string cine = fileOf({at(0, "FLOW_VELOCITY", 9), at(0.1, "TISSUE_INTENSITY", 1),
                                     at(0.2, "FLOW_VELOCITY", 9), at(0.3, "TISSUE_INTENSITY", 2)});
    EXPECT_THAT(readFrames(cine).error().sentence(), HasSubstr("its 2 frames show one plane over time"));
    const auto study = readFrames(cine, true);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{1, 1, 1, 1, 2, 2, 2, 2}));
    EXPECT_TRUE(warnsOf(*study, "left out were 2 of flow velocity"));
}

TEST(FramesShown, TheMiddlePictureIsTheMiddleSliceOfTheTissue) {
    const TemporaryFolder folder;
    // The tissue lies in the order 1, 2, 3 along the normal, and frame n/2 of the file is flow.
    folder.write(
        "v.dcm",
        fileOf({{2, 30}, {0, 10}, {1, 20}, {0, 9, "FLOW_VELOCITY"}, {1, 9, "FLOW_VELOCITY"}, {2, 9, "FLOW_VELOCITY"}}));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_FALSE(list->series[0].whyNot) << list->series[0].whyNot->sentence();
    const auto study = readSeries(*list, list->series[0], withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]).at(4), 20);
    const auto picture = middlePicture(list->series[0], 10);
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->grey, std::vector<std::uint8_t>(4, 255)) << "its own largest value is white";
}

TEST(FrameTimes, OfSlicesThatLieApartMakeOneVolume) {
    std::vector<OneFrame> sweep;
    for (int i = 0; i < 6; ++i)
        sweep.push_back({0.5 * i, static_cast<std::uint16_t>(i + 1), "TISSUE_INTENSITY", "", "", 0.01 * i});
    const auto study = readFrames(fileOf(sweep));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 1u);
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{2, 2, 6}));
    EXPECT_DOUBLE_EQ(study->phases[0]->geometry().spacing[2], 0.5);
    EXPECT_TRUE(warnsOf(*study, "Each of the 6 frames has a time and a place of its own"));
    for (OneFrame& frame : sweep) frame.depth = 1;
    EXPECT_THAT(readFrames(fileOf(sweep)).error().sentence(), HasSubstr("its 6 frames show one plane over time"));
    sweep[3].depth = 2;
    EXPECT_THAT(readFrames(fileOf(sweep)).error().sentence(), HasSubstr("its 6 frames show several planes over time"));
}

TEST(PixelSize, ThatIsNotStatedLeavesTheDistanceOfSlicesAndNoApex) {
    const std::vector<OneFrame> slices{{0, 1}, {0.25, 2}, {0.5, 3}};
    const auto study = readFrames(fileOf(slices, false, true));
    ASSERT_TRUE(study) << study.error().sentence();
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    EXPECT_FALSE(geometry.spacingKnown);
    EXPECT_EQ(geometry.spacing, Vec3(0.25, 0.25, 0.25)) << "the distance of the slices is known";
    EXPECT_FALSE(geometry.probe) << "where the apex lies in voxels cannot be told";
    EXPECT_TRUE(warnsOf(*study, "(0020,9308) Apex Position was left out"));
    EXPECT_TRUE(warnsOf(*study, "The size of the pixels is not stated"));
    const auto known = readFrames(fileOf(slices, true, true));
    ASSERT_TRUE(known) << known.error().sentence();
    EXPECT_TRUE(known->phases[0]->geometry().probe);
    EXPECT_FALSE(warnsOf(*known, "left out"));
}

}  // namespace
}  // namespace echolucent
