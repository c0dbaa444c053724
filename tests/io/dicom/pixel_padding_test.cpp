// Pixel Padding Value and its range: what holds it is no data, in every syntax, sign and kind of file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dicom_images.h"
#include "io/study/series_list.h"
#include "processing/progress.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// Two frames of 4 x 1 pixels of 16 bits.
TestImage paddedImage(const std::vector<int>& values, int padding, bool isSigned = false) {
    TestImage image;
    image.columns = 4;
    image.rows = 1;
    image.frames = 2;
    image.bitsAllocated = image.bitsStored = 16;
    image.isSigned = isSigned;
    for (const int value : values) image.pixels16.push_back(static_cast<std::uint16_t>(value));
    image.padding = padding;
    return image;
}

/// The file's value of each voxel, -9999 where there is no data.
std::vector<double> seenOf(const Volume& volume) {
    std::vector<double> values = storedValues(volume);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!volume.dataMask().empty() && volume.dataMask()[i] == 0) values[i] = -9999;
    return values;
}

constexpr double unseen = -9999;

void expectData(const TestImage& image, const std::vector<double>& values,
                TestSyntax syntax = TestSyntax::explicitLittle) {
    const auto study = writtenAndRead(image, framesAsSlices(), syntax);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(seenOf(*study->phases[0]), values);
}

TEST(PixelPadding, HighValuesOfItAreNeitherDataNorWhite) {
    for (const TestSyntax syntax : {TestSyntax::implicitLittle, TestSyntax::explicitBig, TestSyntax::deflated,
                                    TestSyntax::rle, TestSyntax::jpegLossless}) {
        const auto study = writtenAndRead(paddedImage({60000, 10, 500, 60000, 900, 20, 60000, 59999}, 60000),
                                          framesAsSlices(), syntax);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{unseen, 10, 500, unseen, 900, 20, unseen, 59999}));
        EXPECT_EQ(study->phases[0]->whiteLevel(), 59999);
        EXPECT_TRUE(warnsOf(*study, "Pixels that hold (0028,0120) Pixel Padding Value 60000 are no data."));
        EXPECT_EQ(factOf(*study, "rescaling"), "none");
    }
}

TEST(PixelPadding, SignedOneCountsForNeitherBlackNorRescaling) {
    for (const TestSyntax syntax : {TestSyntax::implicitLittle, TestSyntax::explicitLittle, TestSyntax::explicitBig}) {
        TestImage image = paddedImage({-2000, 10, 500, -2000, 900, -2000, 300, 700}, -2000, true);
        const auto study = writtenAndRead(image, framesAsSlices(), syntax);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{unseen, 10, 500, unseen, 900, unseen, 300, 700}));
        EXPECT_EQ(study->phases[0]->valueWindow(), (ValueWindow{0, 900}));
        EXPECT_FALSE(warnsOf(*study, "-2000, far below"));
        image.rescaleSlope = "2";
        image.rescaleIntercept = "1";
        image.windowCentre = image.windowWidth = "900";  // rescaling is written beside a window
        expectData(image, {unseen, 21, 1001, unseen, 1801, unseen, 601, 1401}, syntax);
    }
}

TEST(PixelPadding, BlackIsTheLeastOfTheDataBesideIt) {
    const auto study =
        writtenAndRead(paddedImage({-2000, -60, -50, -40, -30, -20, -10, -2000}, -2000, true), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->valueWindow(), (ValueWindow{-60, -10}));
    EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{unseen, -60, -50, -40, -30, -20, -10, unseen}));
}

TEST(PixelPadding, OfARangeIsAllFromOneEndToTheOther) {
    for (const bool turned : {false, true}) {
        TestImage image = paddedImage({-2000, -1500, -1000, -999, 900, 1, 2, 3}, turned ? -1000 : -2000, true);
        image.paddingLimit = turned ? -2000 : -1000;
        expectData(image, {unseen, unseen, unseen, -999, 900, 1, 2, 3});
    }
    TestImage fromZero = paddedImage({0, 1, 5, 6, 900, 1, 2, 3}, 0);
    fromZero.paddingLimit = 5;
    expectData(fromZero, {unseen, unseen, unseen, 6, 900, unseen, unseen, unseen});
}

TEST(PixelPadding, OfInvertedPixelsIsComparedBeforeTheyAreInverted) {
    TestImage image = paddedImage({60000, 10, 500, 60000, 900, 20, 60000, 5535}, 60000);
    image.photometric = "MONOCHROME1";
    expectData(image, {unseen, 65525, 65035, unseen, 64635, 65515, unseen, 60000});
    TestImage white = paddedImage({0, 10, 500, 0, 900, 20, 0, 5535}, 0);
    white.photometric = "MONOCHROME1";
    expectData(white, {unseen, 65525, 65035, unseen, 64635, 65515, unseen, 60000});
}

TEST(PixelPadding, OfEightBitsKeepsTheirWhite) {
    TestImage image = paddedImage({}, 250);
    image.bitsAllocated = image.bitsStored = 8;
    image.pixels8 = {250, 1, 2, 3, 100, 250, 5, 6};
    const auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{unseen, 1, 2, 3, 100, unseen, 5, 6}));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 255);
    EXPECT_EQ(sourceOf(*study, "white level"), "(0028,0101) Bits Stored");
}

TEST(PixelPadding, WithTheOtherSignIsTheSameBits) {
    TestImage image = paddedImage({-2000, 10, 500, -2000, 900, 20, 7, 8}, 63536, true);
    expectData(image, {unseen, 10, 500, unseen, 900, 20, 7, 8});
    TestImage beyond = paddedImage({63536, 10, 2096, 63536, 900, 20, 7, 8}, 63536);
    beyond.bitsStored = 12;  // the padding stands in the bits above too
    expectData(beyond, {unseen, 10, 2096, unseen, 900, 20, 7, 8});
}

TEST(PixelPadding, OfZeroStaysAsItWas) {
    const auto study = writtenAndRead(paddedImage({0, 10, 500, 0, 900, 20, 0, 8}, 0), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{0, 10, 500, 0, 900, 20, 0, 8}));
    EXPECT_EQ(study->phases[0]->typeName(), "uint16");
    TestImage unstated = paddedImage({60000, 10, 500, 60000, 900, 20, 7, 8}, 0);
    unstated.padding.reset();
    unstated.paddingLimit = 60000;  // a limit alone says nothing
    const auto as = writtenAndRead(unstated, framesAsSlices());
    ASSERT_TRUE(as) << as.error().sentence();
    EXPECT_EQ(as->phases[0]->typeName(), "uint16");
    EXPECT_EQ(as->phases[0]->storedValue(0), 60000);
}

TEST(PixelPadding, ThatLeavesNothingIsLeftOutAndSaid) {
    TestImage image = paddedImage({0, 10, 500, 0, 900, 20, 0, 8}, 0);
    image.paddingLimit = 65535;
    const auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{0, 10, 500, 0, 900, 20, 0, 8}));
    EXPECT_TRUE(warnsOf(*study, "would leave no value for the picture; it was left out"));
}

TEST(PixelPadding, OfSlicesMayStandInSomeOfThem) {
    const TemporaryFolder folder;
    for (int i = 0; i < 3; ++i) {
        TestImage image = paddedImage({60000, 100 + i, 7, 8}, 60000);
        if (i == 0) image.padding.reset();
        if (i == 0) image.pixels16[0] = 9;
        makeSlice(image, i, 0.5);
        writeDicom(folder.file(std::to_string(i)), image);
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(seenOf(*study->phases[0]), (std::vector<double>{9, 100, 7, 8, unseen, 101, 7, 8, unseen, 102, 7, 8}));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 102);
    EXPECT_TRUE(warnsOf(*study, "Pixel Padding Value 60000 are no data. (Said of 2 of 3 slices.)"));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    const auto small = middlePicture(list->series.front(), 4, Progress());
    ASSERT_TRUE(small) << small.error().sentence();
    EXPECT_EQ(small->grey, (std::vector<std::uint8_t>{0, 255, 18, 20})) << "padding is black there";
}

}  // namespace
}  // namespace echolucent
