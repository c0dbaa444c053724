// Frames that no offset table tells apart, tables that lie, delimiters that are missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <iterator>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

constexpr int frameCount = 2;

std::vector<std::uint8_t> ramp() {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 16 * 8; ++i) pixels.push_back(static_cast<std::uint8_t>(i + 20));
    return pixels;
}

/// The codestreams of two equal frames of 16 x 8 pixels, as an independent writer makes them.
std::vector<std::string> codestreams(const std::string& syntax) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a");
    if (syntax == jpeg2000Syntax) {
        writeJpeg2000Dicom(path, 16, 8, ramp());
    } else {
        TestImage image;
        image.columns = 16;
        image.rows = 8;
        image.frames = frameCount;
        for (int frame = 0; frame < frameCount; ++frame)
            for (const std::uint8_t pixel : ramp()) image.pixels8.push_back(pixel);
        writeDicom(path, image, syntax == jpegLsSyntax ? TestSyntax::jpegLs : TestSyntax::jpegLossless);
    }
    DcmFileFormat file;
    file.loadFile(path.c_str());
    DcmElement* element = nullptr;
    DcmPixelSequence* sequence = nullptr;
    file.getDataset()->findAndGetElement(DCM_PixelData, element);
    static_cast<DcmPixelData*>(element)->getEncapsulatedRepresentation(file.getDataset()->getOriginalXfer(), nullptr,
                                                                       sequence);
    std::vector<std::string> streams;
    for (unsigned long i = 1; i < sequence->card(); ++i) {
        DcmPixelItem* item = nullptr;
        Uint8* bytes = nullptr;
        sequence->getItem(item, i);
        item->getUint8Array(bytes);
        streams.emplace_back(reinterpret_cast<const char*>(bytes), item->getLength());
    }
    return streams;
}

/// Each codestream cut into two fragments.
std::vector<std::string> inHalves(const std::vector<std::string>& streams) {
    std::vector<std::string> halves;
    for (const std::string& stream : streams) {
        const std::size_t half = stream.size() / 4 * 2;
        halves.push_back(stream.substr(0, half));
        halves.push_back(stream.substr(half));
    }
    return halves;
}

DicomBytes picture(int frames = frameCount) { return DicomBytes().picture(16, 8, frames); }

Result<Study> readBytes(const std::string& bytes) {
    const TemporaryFolder folder;
    return readStudy(folder.write("a.dcm", bytes), framesAsSlices());
}

void expectTheRampTwice(const Result<Study>& study) {
    ASSERT_TRUE(study) << study.error().sentence();
    std::vector<double> twice;
    for (int frame = 0; frame < frameCount; ++frame)
        for (const std::uint8_t pixel : ramp()) twice.push_back(pixel);
    EXPECT_EQ(storedValues(*study->phases[0]), twice);
}

class FragmentSyntaxes : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, FragmentSyntaxes, testing::Values(jpegLosslessSyntax, jpegLsSyntax, jpeg2000Syntax),
                         [](const auto& row) { return "Syntax" + std::to_string(row.index); });

TEST_P(FragmentSyntaxes, AreToldApartByTheirCodestreams) {
    const auto halves = inHalves(codestreams(GetParam()));
    const auto study = readBytes(picture().fragments("", halves).file(cineClass, GetParam()));
    expectTheRampTwice(study);
    EXPECT_FALSE(warnsOf(*study, "offset table"));
}

TEST_P(FragmentSyntaxes, AreToldApartByTheExtendedOffsetTable) {
    const auto halves = inHalves(codestreams(GetParam()));
    const std::uint64_t second = 16 + halves[0].size() + halves[1].size();
    const auto table = bytesFrom<std::uint64_t>({0, second});
    expectTheRampTwice(
        readBytes(picture().put(0x7fe0, 0x0001, "OV", table).fragments("", halves).file(cineClass, GetParam())));
}

TEST_P(FragmentSyntaxes, ATableThatLiesIsNotFollowed) {
    const auto halves = inHalves(codestreams(GetParam()));
    for (const auto& table :
         std::vector<std::vector<std::uint32_t>>{{0, 4}, {8, 16}, {0, 0xffffffff}, {5, 0}, {0}, {0, 1, 2}}) {
        const auto study = readBytes(picture().fragments(bytesFrom(table), halves).file(cineClass, GetParam()));
        expectTheRampTwice(study);
        EXPECT_TRUE(warnsOf(*study, "offset table of the pixels does not match")) << testing::PrintToString(table);
    }
    for (const auto& table : std::vector<std::vector<std::uint64_t>>{{0, 1ULL << 63}, {7, 7}, {}})
        expectTheRampTwice(readBytes(
            picture().put(0x7fe0, 0x0001, "OV", bytesFrom(table)).fragments("", halves).file(cineClass, GetParam())));
}

TEST_P(FragmentSyntaxes, ThatDoNotAgreeWithTheFramesAreRefused) {
    auto halves = inHalves(codestreams(GetParam()));
    halves.push_back(halves.front());
    const auto more = readBytes(picture().fragments("", halves).file(cineClass, GetParam()));
    ASSERT_FALSE(more);
    EXPECT_THAT(more.error().sentence(),
                HasSubstr("(7fe0,0010) Pixel Data holds 5 fragments for 2 frames and no offset "
                          "table that tells them apart; 3 of them begin a picture"));
    const auto fewer = readBytes(picture(9).fragments("", halves).file(cineClass, GetParam()));
    ASSERT_FALSE(fewer);
    EXPECT_THAT(fewer.error().sentence(), HasSubstr("holds 5 fragments where 9 frames need at least as many"));
}

TEST_P(FragmentSyntaxes, ADelimiterMissingAtTheEndIsPutRight) {
    const auto streams = codestreams(GetParam());
    const auto study = readBytes(picture().fragments("", streams, false).file(cineClass, GetParam()));
    expectTheRampTwice(study);
    EXPECT_TRUE(warnsOf(*study, "ends without the delimiter"));
}

TEST_P(FragmentSyntaxes, ACutFragmentIsNotTakenForAMissingDelimiter) {
    const auto streams = codestreams(GetParam());
    const std::string whole = picture().fragments("", streams, false).file(cineClass, GetParam());
    for (const std::size_t cut : {1UL, 2UL, 40UL, streams[1].size(), streams[1].size() + 4}) {
        const auto study = readBytes(whole.substr(0, whole.size() - cut));
        ASSERT_FALSE(study) << cut;
        EXPECT_THAT(study.error().sentence(), HasSubstr("in the middle of an element")) << cut;
    }
}

TEST(DicomRepairs, DelimitersOfNestedSequencesMayBeMissingToo) {
    DicomBytes file = picture(0);
    file.put(0x7fe0, 0x0010, "OW", std::string(128, 'a'));
    const std::string endless =
        std::string("\xfc\xff\x05\x00SQ\0\0\xff\xff\xff\xff", 12) + std::string("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8);
    const auto study = readBytes(file.file(cineClass) + endless);
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("is a single 2D picture"));
}

TEST(DicomRepairs, ItemsOfASequenceThatIsDeclaredEmptyAreItsOwn) {
    DicomBytes item;
    item.text(0x0008, 0x0100, "SH", "CODE");
    DicomBytes file;
    file.sequence(0x0008, 0x2218, {item, item}, 0);
    const std::string body = file.bytes() + picture().bytes();
    DicomBytes pixels;
    pixels.put(0x7fe0, 0x0010, "OW", std::string(256, 'a'));
    const std::string whole = DicomBytes().file(cineClass) + body + pixels.bytes();
    const auto study = readBytes(whole);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{16, 8, 2}));
    EXPECT_TRUE(warnsOf(*study, "declared to be empty although items follow"));
}

TEST(DicomRepairs, AnItemThatBelongsToNoSequenceIsLeftOut) {
    DicomBytes item;
    item.word(0x0028, 0x0010, 99);  // not the rows of the picture
    DicomBytes file;
    file.text(0x0008, 0x0060, "CS", "US");
    DicomBytes pixels;
    pixels.put(0x7fe0, 0x0010, "OW", std::string(256, 'a'));
    const std::string items = dicomItem(item.bytes()) + dicomItem(item.bytes());
    const auto study = readBytes(file.file(cineClass) + items + picture().bytes() + pixels.bytes());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{16, 8, 2}));
    EXPECT_TRUE(warnsOf(*study, "An item that belongs to no sequence is left out"));
}

TEST(DicomRepairs, NumbersOfUnknownRepresentationAreWhatTheDictionaryKnows) {
    DicomBytes file;
    file.put(0x0028, 0x0002, "UN", bytesFrom<std::uint16_t>({1})).text(0x0028, 0x0004, "UN", "MONOCHROME2");
    file.text(0x0028, 0x0008, "UN", "2").put(0x0028, 0x0010, "UN", bytesFrom<std::uint16_t>({24}));
    file.put(0x0028, 0x0011, "UN", bytesFrom<std::uint16_t>({16})).text(0x0028, 0x0030, "UN", "0.5\\0.25");
    for (const auto& [element, value] :
         std::vector<std::pair<std::uint16_t, std::uint16_t>>{{0x0100, 8}, {0x0101, 8}, {0x0102, 7}, {0x0103, 0}})
        file.put(0x0028, element, "UN", bytesFrom<std::uint16_t>({value}));
    const auto study = readBytes(file.put(0x7fe0, 0x0010, "OW", std::string(768, 'a')).file(cineClass));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{16, 24, 2}));
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.25, 0.5, 0.375));
}

TEST(DicomRepairs, WhatStandsBehindThePixelsMayBeAnything) {
    DicomBytes file = picture();
    file.put(0x7fe0, 0x0010, "OW", std::string(256, 'a'));
    for (const std::string& rubbish : {std::string(40, '\0'), std::string(41, 'x'), std::string("\xfe\xff", 2)}) {
        const auto study = readBytes(file.file(cineClass) + rubbish);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->storedValue(0), 'a');
    }
}

TEST(DicomScale, OfACineTakenAsSlicesIsKeptInItsPlane) {
    const auto region = [](std::uint16_t format, std::uint32_t right, double deltaX, std::uint16_t unit) {
        DicomBytes one;
        one.word(0x0018, 0x6012, format);
        for (const auto& [element, value] : std::vector<std::pair<std::uint16_t, std::uint32_t>>{
                 {0x6018, 0}, {0x601a, 0}, {0x601c, right}, {0x601e, 7}})
            one.put(0x0018, element, "UL", bytesFrom<std::uint32_t>({value}));
        return one.word(0x0018, 0x6024, unit)
            .word(0x0018, 0x6026, unit)
            .real(0x0018, 0x602c, deltaX)
            .real(0x0018, 0x602e, -0.03);
    };
    const auto cine = [](DicomBytes file) {
        const std::string bytes = file.bytes() + picture().bytes();
        DicomBytes pixels;
        pixels.put(0x7fe0, 0x0010, "OW", std::string(256, 'a'));
        return readBytes(DicomBytes().file(cineClass) + bytes + pixels.bytes());
    };
    // A small 2D region, a larger one of the same scale, a spectrum, one whose unit is no length.
    DicomBytes regions;
    regions.sequence(0x0018, 0x6011,
                     {region(1, 3, 0.01, 3), region(1, 9, 0.01, 3), region(3, 15, 0.7, 3), region(1, 15, 0.9, 4)});
    const auto study = cine(regions);
    ASSERT_TRUE(study) << study.error().sentence();
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    EXPECT_LT(length(geometry.spacing - Vec3(0.1, 0.3, 0.2)), 1e-12);
    EXPECT_FALSE(geometry.spacingKnown) << "the distance of the slices is a guess";
    EXPECT_TRUE(warnsOf(*study, "distance of the slices is unknown; 0.2 mm is assumed"));
    for (const ImportFact& fact : study->facts)
        if (fact.name == "spacing") {
            EXPECT_EQ(fact.source, "(0018,602c), (0018,602e) of the largest 2D region; distance of slices assumed");
        }

    DicomBytes spectrum;
    spectrum.sequence(0x0018, 0x6011, {region(3, 9, 0.01, 3)});
    const auto without = cine(spectrum);
    ASSERT_TRUE(without) << without.error().sentence();
    EXPECT_EQ(without->phases[0]->geometry().spacing, Vec3(1, 1, 1));
    EXPECT_TRUE(warnsOf(*without, "The spacing of the voxels is unknown"));
}

}  // namespace
}  // namespace echolucent
