// White from the display window that a DICOM file declares, or not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "dicom_images.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// Two frames of 16 x 16 that hold 0 to 158 of 15 stored bits, with this window.
TestImage small(const std::string& centre, const std::string& width) {
    TestImage image;
    image.columns = image.rows = 16;
    image.frames = 2;
    image.bitsAllocated = 16;
    image.bitsStored = 15;
    for (int i = 0; i < 512; ++i) image.pixels16.push_back(static_cast<std::uint16_t>(i % 159));
    image.windowCentre = centre;
    image.windowWidth = width;
    return image;
}

Study windowedStudy(const TestImage& image) {
    auto study = writtenAndRead(image, framesAsSlices());
    EXPECT_TRUE(study) << study.error().sentence();
    return study ? *study : Study{};
}

double whiteOf(const Study& study) { return study.phases.at(0)->whiteLevel(); }

std::string sourceOfWhite(const Study& study) {
    for (const ImportFact& fact : study.facts)
        if (fact.name == "white level") return fact.source;
    return "none";
}

TEST(DicomWindow, WhiteIsCentrePlusHalfTheWidth) {
    const Study study = windowedStudy(small("75", "120"));
    EXPECT_EQ(whiteOf(study), 135);
    EXPECT_EQ(sourceOfWhite(study), "(0028,1050) Window Center, (0028,1051) Width: centre 75, width 120");
    EXPECT_EQ(whiteOf(windowedStudy(small("75\\400", "120\\800"))), 135) << "of several windows the first";
}

TEST(DicomWindow, WithoutOneTheDataSay) {
    const Study study = windowedStudy(small("", ""));
    EXPECT_EQ(whiteOf(study), 158) << "not 32767: the picture would be black";
    EXPECT_EQ(sourceOfWhite(study), "largest value in the data");
    TestImage hot = small("", "");
    hot.pixels16[100] = 32767;
    EXPECT_EQ(whiteOf(windowedStudy(hot)), 158);
    EXPECT_EQ(sourceOfWhite(windowedStudy(hot)), "largest value in the data but for hot voxels");
    EXPECT_TRUE(warnsOf(windowedStudy(hot), "1 voxels hold values up to 32767"));
}

TEST(DicomWindow, CountsInRescaledValues) {
    TestImage image = small("1000", "600");  // 10 x + 100 reaches 1680
    image.rescaleSlope = "10";
    image.rescaleIntercept = "100";
    EXPECT_EQ(whiteOf(windowedStudy(image)), 1300);
    EXPECT_EQ(windowedStudy(image).phases[0]->storedValue(158), 1680);
}

TEST(DicomWindow, OfMonochrome1IsWhiteAtItsDarkEnd) {
    TestImage image = small("32667", "60");  // white below 32637
    for (std::uint16_t& pixel : image.pixels16) pixel = static_cast<std::uint16_t>(32767 - pixel);
    image.photometric = "MONOCHROME1";
    EXPECT_EQ(whiteOf(windowedStudy(image)), 130);
}

TEST(DicomWindow, StandsInFunctionalGroupsToo) {
    TestImage image = small("75", "120");
    image.windowInGroups = true;
    EXPECT_EQ(whiteOf(windowedStudy(image)), 135);
    EXPECT_THAT(sourceOfWhite(windowedStudy(image)), testing::HasSubstr(", all frames"));
    image.rescaleSlope = "0.5";
    image.rescaleIntercept = "60";  // 60 to 139
    EXPECT_EQ(whiteOf(windowedStudy(image)), 135);
    EXPECT_EQ(windowedStudy(image).phases[0]->storedValue(158), 139);
}

TEST(DicomWindow, NonsenseIsNotTakenAndSaid) {
    const std::vector<std::array<std::string, 3>> rows{
        {"-200", "100", "it is not above 0"},
        {"-50", "100", "it is not above 0"},
        {"16384", "32768", "would be black"},
        {"1e300", "10", "would be black"},
        {"10", "20", "most values in the data"},
        {"nan", "100", "are no window"},
        {"75", "", "are no window"},
        {"75", "0", "are no window"},
        {"75", "-120", "are no window"},
        {"seventy", "120", "are no window"},
        {"75", "inf", "are no window"},
        {"\\75", "120", "are no window"},
    };
    for (const auto& [centre, width, words] : rows) {
        const Study study = windowedStudy(small(centre, width));
        EXPECT_EQ(whiteOf(study), 158) << centre << " " << width;
        EXPECT_TRUE(warnsOf(study, words)) << centre << " " << width;
        EXPECT_TRUE(warnsOf(study, "not taken")) << centre << " " << width;
    }
}

TEST(DicomWindow, GivesBlackTooWhereZeroHidesMuch) {
    TestImage image = small("-900", "100");  // -1000 to -842
    image.rescaleSlope = "1";
    image.rescaleIntercept = "-1000";
    const Study study = windowedStudy(image);
    EXPECT_EQ(study.phases[0]->valueWindow(), (ValueWindow{-950, -850}));
    EXPECT_EQ(study.phases[0]->fileValue(158), -842);
    image.windowCentre = "40";  // another organ's: all would be black
    image.windowWidth = "400";
    const Study none = windowedStudy(image);
    EXPECT_EQ(none.phases[0]->valueWindow(), (ValueWindow{-1000, -842}));
    EXPECT_TRUE(warnsOf(none, "The window of the file (centre 40, width 400) is not taken"));
}

TEST(DicomWindow, OfBlackPixelsIsTakenIfFloatsHoldIt) {
    TestImage image = small("75", "120");
    std::ranges::fill(image.pixels16, std::uint16_t{0});
    EXPECT_EQ(whiteOf(windowedStudy(image)), 135);
    for (const char* width : {"1e39", "1e-300"}) {
        image.windowCentre = "0";
        image.windowWidth = width;
        const Study study = windowedStudy(image);
        EXPECT_EQ(whiteOf(study), 1) << width << ": no voxel lies above 0";
        EXPECT_TRUE(warnsOf(study, "no voxel can show it")) << width;
    }
}

TEST(DicomWindow, ALutIsNotAppliedAndSaid) {
    TestImage image = small("75", "120");
    image.lutFunction = "SIGMOID";
    EXPECT_EQ(whiteOf(windowedStudy(image)), 135);
    EXPECT_TRUE(warnsOf(windowedStudy(image), "VOI LUT of the file is not applied"));
    image.lutFunction = "LINEAR";
    EXPECT_FALSE(warnsOf(windowedStudy(image), "VOI LUT"));
}

TEST(DicomWindow, EightBitsNeedNone) {
    TestImage image = small("75", "120");
    image.pixels8.assign(image.pixels16.begin(), image.pixels16.end());
    image.pixels16.clear();
    image.bitsAllocated = image.bitsStored = 8;
    EXPECT_EQ(whiteOf(windowedStudy(image)), 255);
    image.pixels16.assign(image.pixels8.begin(), image.pixels8.end());
    image.pixels8.clear();
    image.bitsAllocated = 16;
    EXPECT_EQ(whiteOf(windowedStudy(image)), 255);
    EXPECT_EQ(sourceOfWhite(windowedStudy(image)), "(0028,0101) Bits Stored");
}

TEST(DicomWindow, SlicesShareTheOneInTheMiddle) {
    const TemporaryFolder folder;
    for (int i = 0; i < 5; ++i) {
        TestImage slice = small(std::to_string(70 + 7 * i * i), "120");
        slice.frames = 0;
        slice.pixels16.resize(256);
        slice.position = Vec3(0, 0, i);
        slice.orientation = {1, 0, 0, 0, 1, 0};
        writeDicom(folder.file("IM" + std::to_string(i)), slice);
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(whiteOf(*study), 158) << "centre 98, width 120";
    EXPECT_THAT(sourceOfWhite(*study), testing::HasSubstr("centre 98, width 120"));
    EXPECT_TRUE(warnsOf(*study, "white from 130 to 242"));
}

}  // namespace
}  // namespace echolucent
