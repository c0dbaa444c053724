// Slice Location Vector as the place of frames, if Frame Increment Pointer names it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// Four frames of 2 x 2 pixels, frame i of value 1 + i.
struct Located {
    std::string locations = "5\\5.8\\6.6\\7.4";
    std::string between{}, position{}, offsets{};
    std::vector<std::uint16_t> pointer{0x0018, 0x2005};
};

Result<Study> readLocated(const Located& said) {
    DicomBytes file;
    if (!said.between.empty()) file.text(0x0018, 0x0088, "DS", said.between);
    if (!said.locations.empty()) file.text(0x0018, 0x2005, "DS", said.locations);
    if (!said.position.empty())
        file.text(0x0020, 0x0032, "DS", said.position).text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2").text(0x0028, 0x0008, "IS", "4");
    file.put(0x0028, 0x0009, "AT", bytesFrom<std::uint16_t>(said.pointer));
    file.word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 2).text(0x0028, 0x0030, "DS", "0.7\\0.6");
    file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    if (!said.offsets.empty()) file.text(0x3004, 0x000c, "DS", said.offsets);
    file.put(0x7fe0, 0x0010, "OB", "\1\1\1\1\2\2\2\2\3\3\3\3\4\4\4\4");
    const TemporaryFolder folder;
    return readStudy(folder.write("a.dcm", file.file("1.2.840.10008.5.1.4.1.1.7.2")), withoutGuess());
}

void expectSlices(const Located& said, const std::vector<double>& frames, double spacing, const Vec3& origin) {
    const auto study = readLocated(said);
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases[0];
    std::vector<double> read;
    for (std::size_t place = 0; place < 4; ++place) read.push_back(volume.storedValue(4 * place));
    EXPECT_EQ(read, frames);
    EXPECT_LT(length(volume.geometry().spacing - Vec3(0.6, 0.7, spacing)), 1e-9);
    EXPECT_LT(length(volume.geometry().origin - origin), 1e-9);
    EXPECT_TRUE(volume.geometry().spacingKnown);
}

TEST(SliceLocations, PlaceTheFramesFromTheFirstOneOn) {
    expectSlices({}, {1, 2, 3, 4}, 0.8, {0, 0, 0});
    expectSlices({.position = "1\\2\\9"}, {1, 2, 3, 4}, 0.8, {1, 2, 9});
    expectSlices({.locations = "7.4\\6.6\\5.8\\5", .position = "1\\2\\9"}, {4, 3, 2, 1}, 0.8, {1, 2, 6.6});
    expectSlices({.locations = "5\\6.6\\5.8\\7.4", .pointer = {0x0018, 0x2001, 0x0018, 0x2005}}, {1, 3, 2, 4}, 0.8,
                 {0, 0, 0});
}

TEST(SliceLocations, AreTakenWhereSpacingBetweenSlicesContradictsThem) {
    expectSlices({.between = "5"}, {1, 2, 3, 4}, 0.8, {0, 0, 0});
    const auto study = readLocated({.between = "5"});
    EXPECT_TRUE(warnsOf(*study,
                        "(0018,0088) Spacing Between Slices is 5 mm, but (0018,2005) Slice Location Vector puts the "
                        "slices 0.8 mm apart; that was taken."));
    EXPECT_EQ(sourceOf(*study, "spacing"), "(0028,0030) Pixel Spacing, (0018,2005) Slice Location Vector");
    for (const char* between : {"0.8", "-0.8", "0.803"})
        EXPECT_FALSE(warnsOf(*readLocated({.between = between}), "that was taken")) << between;
}

TEST(SliceLocations, CountOnlyIfTheyAreNamedAndDiffer) {
    expectSlices({.between = "5", .pointer = {0x0018, 0x2001}}, {1, 2, 3, 4}, 5, {0, 0, 0});
    expectSlices({.locations = "3\\3\\3\\3", .between = "5"}, {1, 2, 3, 4}, 5, {0, 0, 0});
    expectSlices({.offsets = "0\\2\\4\\6"}, {1, 2, 3, 4}, 2, {0, 0, 0});
    const auto onePlane = readLocated({.locations = "3\\3\\3\\3"});
    ASSERT_FALSE(onePlane);
    EXPECT_THAT(onePlane.error().sentence(), HasSubstr("2D cine of 4 frames"));
}

TEST(SliceLocations, OfAnotherNumberOfFramesAreNotTaken) {
    expectSlices({.locations = "5\\6\\7", .between = "5"}, {1, 2, 3, 4}, 5, {0, 0, 0});
    EXPECT_TRUE(warnsOf(*readLocated({.locations = "5\\6\\7", .between = "5"}), "it was left out"));
    for (const char* locations : {"5\\6\\7", "5\\6\\7\\8\\9", "5\\6\\7\\eight"}) {
        const auto study = readLocated({.locations = locations});
        ASSERT_FALSE(study) << locations;
        EXPECT_THAT(study.error().sentence(),
                    HasSubstr("(0018,2005) Slice Location Vector is not one number for each of 4 frames"));
        EXPECT_TRUE(study.error().framesCouldBeSlices);
    }
    const auto twice = readLocated({.locations = "5\\6\\5\\6"});
    ASSERT_FALSE(twice);
    EXPECT_THAT(twice.error().sentence(), HasSubstr("Slice Location Vector"));
}

}  // namespace
}  // namespace echolucent
