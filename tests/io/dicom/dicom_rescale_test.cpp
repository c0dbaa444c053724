// Rescale Slope and Intercept, and segmented palettes: from stored values to the values they stand for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "dicom_images.h"
#include "io/dicom/pixels/dicom_palette.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

TestImage grey(const std::vector<std::uint8_t>& pixels, const std::string& slope, const std::string& intercept) {
    TestImage image;
    image.columns = 2;
    image.rows = 1;
    image.frames = static_cast<int>(pixels.size() / 2);
    image.pixels8 = pixels;
    image.rescaleSlope = slope;
    image.rescaleIntercept = intercept;
    image.windowCentre = "100";  // rescaling is written beside a window
    image.windowWidth = "200";
    return image;
}

TEST(Rescale, ChangesValuesAndWhiteAlike) {
    const auto study = writtenAndRead(grey({0, 1, 100, 255}, "0.5", "10"), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{10, 10.5, 60, 137.5}));
    EXPECT_EQ(study->phases[0]->typeName(), "float32");
    EXPECT_EQ(study->phases[0]->whiteLevel(), 137.5) << "what the largest stored value means";
    EXPECT_EQ(factOf(*study, "rescaling"), "slope 0.5, intercept 10");
}

TEST(Rescale, OneAndZeroChangeNothing) {
    const auto study = writtenAndRead(grey({0, 1, 100, 255}, "1", "0"), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->typeName(), "uint8");
    EXPECT_EQ(factOf(*study, "rescaling"), "none");
}

TEST(Rescale, OfInvertedPixelsTurnsThemRoundBetweenItsEnds) {
    TestImage image = grey({0, 1, 100, 255}, "2", "100");
    image.photometric = "MONOCHROME1";
    const auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{610, 608, 410, 100}));
}

TEST(Rescale, ManyValuesBelow0MoveBlackToTheLeastOfTheBits) {
    for (const char* photometric : {"MONOCHROME2", "MONOCHROME1"}) {
        TestImage image = grey({1, 2, 100, 250}, "1", "-60");
        image.photometric = photometric;
        const auto study = writtenAndRead(image, framesAsSlices());
        ASSERT_TRUE(study) << study.error().sentence();
        const Volume& volume = *study->phases[0];
        const bool inverted = image.photometric == "MONOCHROME1";
        EXPECT_EQ(volume.valueWindow(), (ValueWindow{-60, 195}));
        EXPECT_EQ(volume.fileValue(0), inverted ? 194 : -59);
        EXPECT_EQ(volume.fileValue(3), inverted ? -55 : 190);
    }
    TestImage few = grey({0, 70, 71, 72, 73, 74, 75, 100, 255, 80, 81, 82}, "1", "-50");
    const auto study = writtenAndRead(few, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(0), -50) << "one of twelve is little";
    EXPECT_EQ(study->phases[0]->whiteLevel(), 205);
    EXPECT_TRUE(warnsOf(*study, "negative values down to -50"));
}

TEST(Rescale, DecibelsOfEightBitsReachFromTheLeastToTheLargest) {
    const auto study = writtenAndRead(grey({100, 101, 102, 255}, "-0.5", "0"), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->valueWindow(), (ValueWindow{-127.5, 0}));
    EXPECT_EQ(study->phases[0]->fileValue(0), -50);
    EXPECT_EQ(sourceOf(*study, "black level"), "(0028,0101) Bits Stored, (0028,1053) Rescale Slope");
    EXPECT_TRUE(warnsOf(*study, "The voxels hold -127.5 to -50: black is -127.5, white 0."));
}

TEST(Rescale, NonsenseIsRefusedWithItsTag) {
    for (const auto& [slope, intercept, words] :
         std::vector<std::array<std::string, 3>>{{"nan", "0", "(0028,1053) Rescale Slope is no number"},
                                                 {"inf", "0", "(0028,1053) Rescale Slope is no number"},
                                                 {"two", "0", "(0028,1053) Rescale Slope is no number"},
                                                 {"1", "nan", "(0028,1052) Rescale Intercept is no number"},
                                                 {"0", "5", "(0028,1053) Rescale Slope is 0"},
                                                 {"1e300", "0", "(0028,1053) Rescale Slope is 1e+300"},
                                                 {"1", "1e300", "(0028,1053) Rescale Slope is 1 with intercept 1e+300"},
                                                 {"1", "1e30", "which makes values from"}}) {
        const auto study = writtenAndRead(grey({0, 1, 100, 255}, slope, intercept), framesAsSlices());
        ASSERT_FALSE(study) << slope << " " << intercept;
        EXPECT_THAT(study.error().sentence(), HasSubstr(words));
    }
}

TEST(Rescale, OfEachFrameIsItsOwn) {
    DicomBytes file;
    const auto groups = [](const char* slope) {
        DicomBytes transformation;
        transformation.text(0x0028, 0x1052, "DS", "1").text(0x0028, 0x1053, "DS", slope);
        return DicomBytes().sequence(0x0028, 0x9145, {transformation});
    };
    file.picture(2, 1, 3).sequence(0x5200, 0x9229, {groups("10")});
    file.sequence(0x5200, 0x9230, {groups("2"), DicomBytes(), groups("3")});
    file.put(0x7fe0, 0x0010, "OW", std::string("\1\2\3\4\5\6", 6));
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("a.dcm", file.file(cineClass)), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{3, 5, 31, 41, 16, 19}));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 2551) << "of the frame that reaches farthest";
}

TEST(Rescale, SlicesWithDifferentSlopesAreAllApplied) {
    const TemporaryFolder folder;
    for (int i = 0; i < 3; ++i) {
        TestImage image = grey({}, i == 0 ? "" : std::to_string(i), i == 0 ? "" : "0.5");
        image.pixels8 = {10, 20};
        makeSlice(image, i, 0.5);
        writeDicom(folder.file(std::to_string(i)), image);
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{10, 20, 10.5, 20.5, 20.5, 40.5}));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 510.5);
    EXPECT_TRUE(warnsOf(*study, "different slopes"));
}

using Entries = std::vector<std::uint16_t>;

TEST(SegmentedPalette, DiscreteLinearAndCopiedSegmentsGiveTheEntries) {
    // Two entries as they are, a line over three to 40, and the first two segments once more.
    const Entries data{0, 2, 10, 20, 1, 3, 50, 2, 2, 0, 0};
    EXPECT_EQ(expandSegments(data, false, 10), (Entries{10, 20, 30, 40, 50, 10, 20, 30, 40, 50}));
    const Entries bytes{0, 2, 10, 20, 1, 2, 30, 2, 1, 4, 0, 0, 0};
    EXPECT_EQ(expandSegments(bytes, true, 6), (Entries{10, 20, 25, 30, 30, 30}));
}

TEST(SegmentedPalette, WhatRunsBeyondIsNoPalette) {
    const std::vector<std::pair<Entries, std::size_t>> rows{
        {{0, 5, 1, 2}, 5},            // beyond the data
        {{0, 3, 1, 2, 3}, 2},         // beyond the entries
        {{1, 2, 9}, 2},               // a line from nothing
        {{0, 1, 5, 1, 65535, 9}, 4},  // a line beyond the entries
        {{0, 1, 5, 1, 2}, 3},         // a line without its end
        {{2, 1, 0, 0}, 1},            // a copy of itself
        {{0, 1, 5, 2, 1, 6, 0}, 2},   // a copy of itself
        {{0, 1, 5, 2, 1, 2, 0}, 2},   // from the middle of a segment
        {{0, 1, 5, 2, 1, 1, 0}, 2},   // from the middle of a word
        {{0, 1, 5, 2, 1, 0xffff, 0xffff}, 2},
        {{0, 1, 5, 2, 0xffff, 0, 0}, 70000},
        {{0, 1, 5, 2, 1}, 2},
        {{0, 0, 0, 0, 0, 0, 0, 0}, 4},  // segments of nothing
        {{7, 1, 5}, 1},
        {{0, 1, 5}, 2},  // too few
        {{}, 1},
    };
    for (const auto& [data, count] : rows)
        EXPECT_FALSE(expandSegments(data, false, count)) << testing::PrintToString(data);
}

TEST(SegmentedPalette, OfAFileIsDecoded) {
    const auto file = [](const std::string& red) {
        DicomBytes bytes;
        bytes.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "PALETTE COLOR").text(0x0028, 0x0008, "IS", "2");
        bytes.word(0x0028, 0x0010, 1).word(0x0028, 0x0011, 2).word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8);
        bytes.word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
        for (const std::uint16_t colour : {0x1101, 0x1102, 0x1103})
            bytes.put(0x0028, colour, "US", bytesFrom<std::uint16_t>({4, 0, 16}));
        const auto line = bytesFrom<std::uint16_t>({0, 1, 0, 1, 3, 0xff00});
        bytes.put(0x0028, 0x1221, "OW", red).put(0x0028, 0x1222, "OW", line).put(0x0028, 0x1223, "OW", line);
        return bytes.put(0x7fe0, 0x0010, "OW", std::string("\0\1\2\3", 4)).file(cineClass);
    };
    const TemporaryFolder folder;
    const auto good = folder.write("good", file(bytesFrom<std::uint16_t>({0, 1, 0, 1, 3, 0xff00})));
    const auto study = readStudy(good, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{0, 85, 170, 255}));
    EXPECT_EQ(factOf(*study, "palette"), "stored in segments");
    const auto bad = readStudy(folder.write("bad", file(bytesFrom<std::uint16_t>({0, 100, 0, 1}))), framesAsSlices());
    ASSERT_FALSE(bad);
    EXPECT_THAT(
        bad.error().sentence(),
        HasSubstr("(0028,1101) Palette Color Lookup Table is stored in segments that do not give its 4 entries"));
}

}  // namespace
}  // namespace echolucent
