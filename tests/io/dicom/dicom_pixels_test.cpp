// Pixels of multi-frame files: every transfer syntax and colour model gives the grey values that were written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dicom_images.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// Two frames of 16 x 8 with a smooth ramp, so that lossy coding stays close.
TestImage ramp8() {
    TestImage image;
    image.columns = 16;
    image.rows = 8;
    image.frames = 2;
    for (int i = 0; i < 256; ++i) image.pixels8.push_back(static_cast<std::uint8_t>(i * 5 / 6 + 20));
    return image;
}

std::vector<double> asDoubles(const std::vector<std::uint8_t>& values) { return {values.begin(), values.end()}; }

class LosslessSyntaxes : public testing::TestWithParam<TestSyntax> {};
INSTANTIATE_TEST_SUITE_P(All, LosslessSyntaxes,
                         testing::Values(TestSyntax::implicitLittle, TestSyntax::explicitLittle,
                                         TestSyntax::explicitBig, TestSyntax::deflated, TestSyntax::rle,
                                         TestSyntax::jpegLossless, TestSyntax::jpegLs));

TEST_P(LosslessSyntaxes, KeepEightBitGrey) {
    const TestImage image = ramp8();
    const auto study = writtenAndRead(image, framesAsSlices(), GetParam());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), asDoubles(image.pixels8));
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{16, 8, 2}));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 255);
    EXPECT_EQ(study->lossyCompression, LossyCompression::unknown);
}

TEST_P(LosslessSyntaxes, KeepTwelveBitGrey) {
    TestImage image = ramp8();
    image.pixels8.clear();
    image.bitsAllocated = 16;
    image.bitsStored = 12;
    for (int i = 0; i < 256; ++i) image.pixels16.push_back(static_cast<std::uint16_t>(i * 16 + 5));
    const auto study = writtenAndRead(image, framesAsSlices(), GetParam());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), std::vector<double>(image.pixels16.begin(), image.pixels16.end()));
    EXPECT_EQ(study->phases[0]->typeName(), "uint16");
    EXPECT_EQ(study->phases[0]->whiteLevel(), 4085) << "the largest value, whatever the bits may hold";
}

TEST_P(LosslessSyntaxes, ReduceColourToLuma) {
    TestImage image = ramp8();
    image.samples = 3;
    image.photometric = "RGB";
    image.pixels8.clear();
    std::vector<double> luma;
    for (int i = 0; i < 256; ++i) {
        const int red = i;
        const int green = 255 - i;
        const int blue = (i * 7) % 256;
        for (const int value : {red, green, blue}) image.pixels8.push_back(static_cast<std::uint8_t>(value));
        luma.push_back(std::lround(0.299 * red + 0.587 * green + 0.114 * blue));
    }
    const auto study = writtenAndRead(image, framesAsSlices(), GetParam());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), luma);
    EXPECT_TRUE(warnsOf(*study, "luma"));
}

TEST(DicomPixels, OddFrameSizesAreReadInEveryNativeSyntax) {
    for (const TestSyntax syntax :
         {TestSyntax::implicitLittle, TestSyntax::explicitLittle, TestSyntax::explicitBig, TestSyntax::deflated,
          TestSyntax::rle, TestSyntax::jpegLossless, TestSyntax::jpegLs}) {
        TestImage image;
        image.columns = 3;
        image.rows = 3;
        image.frames = 3;
        for (int i = 0; i < 27; ++i) image.pixels8.push_back(static_cast<std::uint8_t>(9 * i));
        const std::vector<double> written = asDoubles(image.pixels8);
        image.pixels8.push_back(0);
        const auto study = writtenAndRead(image, framesAsSlices(), syntax);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(storedValues(*study->phases[0]), written) << static_cast<int>(syntax);
    }
}

TEST(DicomPixels, PlanarColourGivesTheSameLuma) {
    TestImage image;
    image.columns = 2;
    image.rows = 1;
    image.frames = 2;
    image.samples = 3;
    image.photometric = "RGB";
    image.planar = 1;
    image.pixels8 = {200, 10, 100, 20, 50, 30, 0, 255, 0, 255, 0, 255};
    for (const TestSyntax syntax : {TestSyntax::explicitLittle, TestSyntax::explicitBig, TestSyntax::rle}) {
        const auto study = writtenAndRead(image, framesAsSlices(), syntax);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{124, 18, 0, 255}));
    }
}

TEST(DicomPixels, YbrGivesItsFirstSample) {
    TestImage image;
    image.columns = 2;
    image.rows = 1;
    image.frames = 2;
    image.samples = 3;
    image.photometric = "YBR_FULL";
    image.pixels8 = {11, 128, 140, 22, 128, 140, 33, 99, 99, 44, 99, 99};
    auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{11, 22, 33, 44}));

    image.photometric = "YBR_FULL_422";
    image.pixels8 = {11, 22, 128, 140, 33, 44, 99, 99};
    study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{11, 22, 33, 44}));
}

TEST(DicomPixels, PaletteIsReducedToLumaIn8And16Bits) {
    TestImage image;
    image.columns = 2;
    image.rows = 2;
    image.frames = 2;
    image.photometric = "PALETTE COLOR";
    image.pixels8 = {9, 10, 11, 12, 13, 14, 200, 10};
    TestPalette palette;
    palette.first = 10;
    palette.red = {200 << 8, 0, 0, 0xffff};
    palette.green = {100 << 8, 0, 0xffff, 0xffff};
    palette.blue = {50 << 8, 0, 0, 0xffff};
    image.palette = palette;
    // The table holds 124, 0, 150, 255; values outside the table take its first or last entry.
    const std::vector<double> luma{124, 124, 0, 150, 255, 255, 255, 124};
    auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), luma);
    EXPECT_EQ(study->phases[0]->whiteLevel(), 255);

    image.palette->bits = 8;
    image.palette->red = {200, 255 << 8};
    image.palette->green = {100, 255 | 255 << 8};
    image.palette->blue = {50, 255 << 8};
    study = writtenAndRead(image, framesAsSlices(), TestSyntax::rle);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), luma);
}

TEST(DicomPixels, Monochrome1IsInverted) {
    TestImage image = ramp8();
    image.photometric = "MONOCHROME1";
    const auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], 255 - image.pixels8[i]);
    EXPECT_TRUE(warnsOf(*study, "inverted"));
}

TEST(DicomPixels, SignedValuesKeepTheirSign) {
    TestImage image;
    image.columns = 2;
    image.rows = 1;
    image.frames = 2;
    image.bitsAllocated = 16;
    image.bitsStored = 12;
    image.isSigned = true;
    image.pixels16 = {5, static_cast<std::uint16_t>(-5), 2047, static_cast<std::uint16_t>(-2048)};
    for (const TestSyntax syntax : {TestSyntax::explicitLittle, TestSyntax::explicitBig, TestSyntax::rle}) {
        const auto study = writtenAndRead(image, framesAsSlices(), syntax);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{5, -5, 2047, -2048}));
        EXPECT_EQ(study->phases[0]->valueWindow(), (ValueWindow{-2048, 2047}));
    }
}

TEST(DicomPixels, LossIsSaidAsFarAsTheFileTells) {
    TestImage image = ramp8();
    image.lossyImageCompression = "00";
    auto study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->lossyCompression, LossyCompression::no);
    EXPECT_EQ(sourceOf(*study, "lossy compression"), "(0028,2110) Lossy Image Compression");
    image.lossyImageCompression = "01";  // compressed once, whatever it is stored as now
    study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->lossyCompression, LossyCompression::yes);
    image.lossyImageCompression = "";
    study = writtenAndRead(image, framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(factOf(*study, "lossy compression"), "unknown");

    // The single images of a series of ultrasound must state loss, and one that does counts for all.
    const TemporaryFolder folder;
    TestImage slice = writeThreeSlices(folder);
    study = readStudy(folder.path());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->lossyCompression, LossyCompression::no);
    slice.lossyImageCompression = "01";
    writeDicom(folder.file("2.dcm"), slice);
    study = readStudy(folder.path());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->lossyCompression, LossyCompression::yes);
}

TEST(DicomPixels, LossyJpegIsCloseAndSaid) {
    TestImage image = ramp8();
    // The pixels have the full range, because the encoder stretches a narrower one.
    for (int i = 0; i < 256; ++i) image.pixels8[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i);
    auto study = writtenAndRead(image, framesAsSlices(), TestSyntax::jpegBaseline);
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], image.pixels8[i], 6) << i;
    EXPECT_EQ(study->lossyCompression, LossyCompression::yes);
    EXPECT_EQ(factOf(*study, "lossy compression"), "yes");

    // In colour the encoder turns RGB into YBR: the decoder's first sample must still be the luma.
    TestImage colour = ramp8();
    colour.samples = 3;
    colour.photometric = "RGB";
    colour.pixels8.clear();
    for (const std::uint8_t value : image.pixels8)
        for (const double share : {1.0, 0.5, 0.2}) colour.pixels8.push_back(static_cast<std::uint8_t>(value * share));
    study = writtenAndRead(colour, framesAsSlices(), TestSyntax::jpegBaseline);
    ASSERT_TRUE(study) << study.error().sentence();
    const auto lumas = storedValues(*study->phases[0]);
    for (std::size_t i = 0; i < lumas.size(); ++i) EXPECT_NEAR(lumas[i], image.pixels8[i] * 0.6153, 8) << i;
}

TEST(DicomPixels, Jpeg2000IsRead) {
    const TemporaryFolder folder;
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 64; ++i) pixels.push_back(static_cast<std::uint8_t>(4 * i));
    writeJpeg2000Dicom(folder.file("a.dcm"), 8, 8, pixels);
    const auto study = readStudy(folder.file("a.dcm"), framesAsSlices());
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    ASSERT_EQ(values.size(), 128U);
    for (std::size_t i = 0; i < 128; ++i) EXPECT_EQ(values[i], pixels[i % 64]);
}

TEST(DicomPixels, NothingAboutThePatientIsSaid) {
    const auto study = writtenAndRead(ramp8(), framesAsSlices());
    ASSERT_TRUE(study);
    EXPECT_EQ(factOf(*study, "manufacturer"), "Test Maker");
    for (const ImportFact& fact : study->facts) {
        EXPECT_THAT(fact.value, Not(HasSubstr("ecret")));
        EXPECT_THAT(fact.value, Not(HasSubstr("SECRET")));
    }
}

TEST(DicomPixels, WhatCannotBeTrueIsRefusedBeforeMemoryIsTaken) {
    const auto sentenceWith = [](const std::function<void(TestImage&)>& change,
                                 TestSyntax syntax = TestSyntax::explicitLittle) {
        TestImage image = ramp8();
        change(image);
        const auto study = writtenAndRead(image, framesAsSlices(), syntax);
        return study ? std::string("was read") : study.error().sentence();
    };
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.rows = 9; }),
                HasSubstr("holds 256 bytes where 16 x 9 pixels in 2 frame(s) need 288"));
    EXPECT_THAT(sentenceWith([](TestImage& i) {
                    i.rows = i.columns = 65535;
                    i.frames = 100000000;
                }),
                HasSubstr("(7fe0,0010) Pixel Data holds 256 bytes"));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.rows = 0; }), HasSubstr("(0028,0010) Rows"));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.columns = 0; }), HasSubstr("(0028,0011) Columns"));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.bitsAllocated = 32; }),
                HasSubstr("(0028,0100) Bits Allocated is 32"));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.bitsStored = 9; }),
                HasSubstr("(0028,0101) Bits Stored is 9 where 8"));
    EXPECT_THAT(sentenceWith([](TestImage& i) {
                    i.photometric = "HSV";
                    i.samples = 3;
                }),
                HasSubstr("(0028,0004) Photometric Interpretation is \"HSV\""));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.photometric = "RGB"; }),
                HasSubstr("(0028,0002) Samples per Pixel is 1 where RGB needs 3"));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.photometric = "PALETTE COLOR"; }),
                HasSubstr("Palette Color Lookup Table is missing"));
    EXPECT_THAT(sentenceWith([](TestImage& i) { i.pixels8.clear(); }), HasSubstr("Pixel Data is absent"));
}

TEST(DicomPixels, TruncatedFilesAreRefusedAtEveryLength) {
    const TemporaryFolder folder;
    for (const TestSyntax syntax :
         {TestSyntax::explicitLittle, TestSyntax::rle, TestSyntax::jpegLossless, TestSyntax::jpegLs}) {
        writeDicom(folder.file("a.dcm"), ramp8(), syntax);
        std::ifstream stream(folder.file("a.dcm"), std::ios::binary);
        const std::string whole((std::istreambuf_iterator<char>(stream)), {});
        for (std::size_t length = 0; length + 8 < whole.size(); length += 7) {
            const auto study = readStudy(folder.write("cut.dcm", whole.substr(0, length)), framesAsSlices());
            ASSERT_FALSE(study) << "cut to " << length << " of " << whole.size();
            EXPECT_FALSE(study.error().problem.empty());
        }
    }
}

TEST(DicomPixels, FalseSizesInCompressedFramesAreFoundOut) {
    const TemporaryFolder folder;
    const std::vector<std::pair<TestSyntax, std::string>> rows{{TestSyntax::rle, "pixels, which cannot be"},
                                                               {TestSyntax::jpegLossless, "JPEG frame of 16 x 8"},
                                                               {TestSyntax::jpegLs, "JPEG frame of 16 x 8"}};
    for (const auto& [syntax, words] : rows) {
        writeDicom(folder.file("a.dcm"), ramp8(), syntax);
        std::ifstream stream(folder.file("a.dcm"), std::ios::binary);
        std::string bytes((std::istreambuf_iterator<char>(stream)), {});
        const auto place = bytes.find(std::string("\x28\0\x10\0US\x02\0\x08\0", 10));
        ASSERT_NE(place, std::string::npos);
        bytes[place + 8] = '\xff';
        bytes[place + 9] = '\x7f';
        const auto study = readStudy(folder.write("b.dcm", bytes), framesAsSlices());
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(), HasSubstr(words));
    }
}

}  // namespace
}  // namespace echolucent
