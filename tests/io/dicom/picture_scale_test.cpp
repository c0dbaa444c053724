// The size of pixels and the distance of slices by ultrasound regions, Spacing Between Slices and Pixel Aspect Ratio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// One item of the Sequence of Ultrasound Regions.
struct Region {
    std::uint32_t left = 0, right = 7;
    double deltaX = 0.06, deltaY = 0.07;  ///< cm, as the units say
    std::uint16_t format = 1;             ///< 2D
    std::uint16_t unitX = 3, unitY = 3;   ///< cm
};

DicomBytes itemOf(const Region& region) {
    DicomBytes item;
    item.word(0x0018, 0x6012, region.format);
    for (const auto& [element, value] : std::vector<std::pair<std::uint16_t, std::uint32_t>>{
             {0x6018, region.left}, {0x601a, 0}, {0x601c, region.right}, {0x601e, 3}})
        item.put(0x0018, element, "UL", bytesFrom<std::uint32_t>({value}));
    item.word(0x0018, 0x6024, region.unitX).word(0x0018, 0x6026, region.unitY);
    return item.real(0x0018, 0x602c, region.deltaX).real(0x0018, 0x602e, region.deltaY);
}

/// What stands in front of the pixels of 8 x 4.
struct Said {
    std::string between{};
    std::vector<Region> regions{};
    std::string aspect{};
    bool followInTime = false;
    int instance = 0;  ///< of a picture of a series; 0 if it is a file of three frames
    std::string position{};
    std::string cineRate{}, frameTime{}, frameTimes{};  ///< that no pointer names
};

std::string fileOf(const Said& said) {
    DicomBytes file;
    file.text(0x0008, 0x0060, "CS", "US");
    if (!said.cineRate.empty()) file.text(0x0018, 0x0040, "IS", said.cineRate);
    if (!said.between.empty()) file.text(0x0018, 0x0088, "DS", said.between);
    if (said.followInTime) file.text(0x0018, 0x1063, "DS", "40");
    if (!said.frameTime.empty()) file.text(0x0018, 0x1063, "DS", said.frameTime);
    if (!said.frameTimes.empty()) file.text(0x0018, 0x1065, "DS", said.frameTimes);
    if (!said.regions.empty()) {
        std::vector<DicomBytes> items;
        for (const Region& region : said.regions) items.push_back(itemOf(region));
        file.sequence(0x0018, 0x6011, items);
    }
    file.text(0x0020, 0x000e, "UI", "1.2.3");
    if (said.instance > 0) file.text(0x0020, 0x0013, "IS", std::to_string(said.instance));
    if (!said.position.empty())
        file.text(0x0020, 0x0032, "DS", said.position).text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
    const int frames = said.instance > 0 ? 1 : 3;
    if (frames > 1) file.text(0x0028, 0x0008, "IS", "3");
    if (said.followInTime) file.put(0x0028, 0x0009, "AT", bytesFrom<std::uint16_t>({0x0018, 0x1063}));
    file.word(0x0028, 0x0010, 4).word(0x0028, 0x0011, 8);
    if (!said.aspect.empty()) file.text(0x0028, 0x0034, "IS", said.aspect);
    file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    file.put(0x7fe0, 0x0010, "OB", std::string(static_cast<std::size_t>(32 * frames), 'a'));
    return file.file(frames > 1 ? cineClass : pictureClass);
}

Result<Study> readFile(const Said& said, bool asSlices = true) {
    const TemporaryFolder folder;
    return readStudy(folder.write("a.dcm", fileOf(said)), asSlices ? framesAsSlices() : withoutGuess());
}

/// Three pictures of a series, with positions or without.
Result<Study> readFolder(Said said, bool placed) {
    const TemporaryFolder folder;
    for (said.instance = 1; said.instance <= 3; ++said.instance) {
        if (placed) said.position = "0\\0\\" + std::to_string(said.instance * 2);
        folder.write(std::to_string(said.instance) + ".dcm", fileOf(said));
    }
    return readStudy(folder.path(), framesAsSlices());
}

void expectSpacing(const Result<Study>& study, const Vec3& spacing, bool known) {
    ASSERT_TRUE(study) << study.error().sentence();
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    EXPECT_LT(length(geometry.spacing - spacing), 1e-9);
    EXPECT_EQ(geometry.spacingKnown, known);
}

TEST(PictureScale, SpacingBetweenSlicesBesideRegionsMakesAVolume) {
    const auto study = readFile({.between = "0.8", .regions = {{}}}, false);
    expectSpacing(study, {0.6, 0.7, 0.8}, true);
    EXPECT_EQ(sourceOf(*study, "spacing"),
              "(0018,602c), (0018,602e) of the largest 2D region, (0018,0088) Spacing Between Slices");
    // Negative distances run against the order of the frames, deltas below 0 are as long as others.
    expectSpacing(readFile({.between = "-0.8", .regions = {{.deltaX = -0.06}}}, false), {0.6, 0.7, 0.8}, true);
    EXPECT_FALSE(readFile({.between = "0", .regions = {{}}}, false));
    EXPECT_FALSE(readFile({.between = "0.8", .regions = {{}}, .followInTime = true}, false));
}

TEST(PictureScale, SpacingBetweenSlicesBesideRegionsAndTimesIsAGuess) {
    for (const Said& said : {Said{.between = "-0.8", .regions = {{}}, .cineRate = "30"},
                             Said{.between = "0.8", .regions = {{}}, .frameTime = "33"},
                             Said{.between = "0.8", .regions = {{}}, .frameTimes = "0\\33\\34"}}) {
        const auto study = readFile(said, false);
        expectSpacing(study, {0.6, 0.7, 0.8}, false);
        EXPECT_TRUE(warnsOf(*study, "(0018,0088) Spacing Between Slices is 0.8 mm; it is a guess that the frames are"));
        EXPECT_TRUE(warnsOf(*study, "Within a slice the spacing is known"));
    }
    expectSpacing(readFile({.between = "0.8", .regions = {{}}, .cineRate = "0"}, false), {0.6, 0.7, 0.8}, true);
}

TEST(PictureScale, SpacingBetweenSlicesCountsForPicturesTakenAsSlices) {
    const auto cine = readFile({.between = "0.8", .regions = {{}}, .followInTime = true});
    expectSpacing(cine, {0.6, 0.7, 0.8}, false);
    EXPECT_TRUE(warnsOf(*cine, "it is a guess that the frames are so far apart"));
    EXPECT_TRUE(warnsOf(*cine, "Within a slice the spacing is known"));
    const auto pictures = readFolder({.between = "0.8", .regions = {{}}}, false);
    expectSpacing(pictures, {0.6, 0.7, 0.8}, true);
    EXPECT_EQ(sourceOf(*pictures, "spacing"), "(0018,602c), (0018,602e) of the largest 2D region, (0018,0088)");
    // Positions say more.
    expectSpacing(readFolder({.between = "0.8", .regions = {{}}}, true), {0.6, 0.7, 2}, true);
    expectSpacing(readFolder({.regions = {{}}}, false), {0.6, 0.7, 0.65}, false);
}

TEST(PictureScale, RegionsOfTwoScalesMakeThePixelsUnknown) {
    const std::vector<Region> two{{.right = 4, .deltaX = 0.03, .deltaY = 0.03},
                                  {.left = 5, .deltaX = 0.05, .deltaY = 0.05}};
    for (const auto& study :
         {readFile({.regions = two}), readFile({.regions = {two[1], two[0]}}), readFolder({.regions = two}, false)}) {
        expectSpacing(study, {0.3, 0.3, 0.3}, false);
        EXPECT_TRUE(warnsOf(*study, "2D regions of different scales (0.3 x 0.3 mm and 0.5 x 0.5 mm a pixel)"));
        EXPECT_TRUE(warnsOf(*study, "The spacing of the voxels is unknown"));
        EXPECT_FALSE(warnsOf(*study, "Within a slice the spacing is known"));
    }
    for (const auto& study :
         {readFile({.between = "0.8", .regions = two}, false), readFile({.between = "0.8", .regions = two})}) {
        expectSpacing(study, {0.3, 0.3, 0.8}, false);
        EXPECT_TRUE(warnsOf(*study, "2D regions of different scales"));
    }
    expectSpacing(readFolder({.regions = two}, true), {0.3, 0.3, 2}, false);
}

TEST(PictureScale, RegionsThatAreNoPicturesInCentimetresDoNotCount) {
    const std::vector<Region> others{{.deltaX = 0.01, .format = 3, .unitX = 4, .unitY = 7},
                                     {.deltaX = 0.5, .format = 2},
                                     {.deltaX = 0.9, .unitX = 4},
                                     {.deltaX = 0},
                                     {.deltaY = 1e9}};
    std::vector<Region> all = others;
    all.push_back({.right = 3});
    const auto study = readFile({.regions = all});
    expectSpacing(study, {0.6, 0.7, 0.65}, false);
    EXPECT_TRUE(warnsOf(*study, "Within a slice the spacing is known"));
    expectSpacing(readFile({.regions = others}), {1, 1, 1}, false);
    // One scale, but for rounding.
    all.push_back({.left = 4, .deltaX = 0.0601});
    EXPECT_FALSE(warnsOf(*readFile({.regions = all}), "different scales"));
}

TEST(PictureScale, PixelAspectRatioGivesTheShapeOfPixelsOfUnknownSize) {
    for (const auto& study : {readFile({.aspect = "3\\2"}), readFolder({.aspect = "3\\2"}, false)}) {
        expectSpacing(study, {1, 1.5, 1.25}, false);
        EXPECT_TRUE(warnsOf(*study, "pixels are taken to be 1.5 times as high as wide"));
    }
    expectSpacing(readFile({.between = "0.8", .aspect = "3\\2"}), {0.8, 1.2, 0.8}, false);
    expectSpacing(readFolder({.aspect = "1\\2"}, true), {2, 1, 2}, false);
    expectSpacing(readFile({.regions = {{}}, .aspect = "3\\2"}), {0.6, 0.7, 0.65}, false);
    for (const std::string none : {"1\\1", "0\\1", "1\\0", "-1\\1", "3", "99999999\\1"}) {
        const auto study = readFile({.aspect = none});
        expectSpacing(study, {1, 1, 1}, false);
        EXPECT_FALSE(warnsOf(*study, "Aspect")) << none;
    }
}

}  // namespace
}  // namespace echolucent
