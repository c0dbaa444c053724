// Files whose meta header contradicts the data set behind it, and bytes behind the pixels: the voxels are right all the
// same, and a note says what was assumed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

const std::string implicitSyntax = "1.2.840.10008.1.2";
const std::string explicitSyntax = "1.2.840.10008.1.2.1";
const std::string bigSyntax = "1.2.840.10008.1.2.2";
const std::array writings{implicitSyntax, explicitSyntax, bigSyntax};
const std::string syntaxNote = "(0002,0010) Transfer Syntax is";
const std::string behindNote = "What stands behind the pixels is no DICOM";

/// The elements of a data set in one of three writings.
class Elements {
public:
    explicit Elements(std::string writing) : m_writing(std::move(writing)) {}
    Elements& put(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value,
                  bool endless = false) {
        const bool big = m_writing == bigSyntax;
        if (value.size() % 2 == 1) value += vr == "UI" ? '\0' : ' ';
        bytes += bytesFrom<std::uint16_t>({group, element}, big);
        const auto length = endless ? 0xffffffffU : static_cast<std::uint32_t>(value.size());
        const bool isLong = vr == "OB" || vr == "OW" || vr == "UN" || vr == "SQ";
        if (m_writing == implicitSyntax)
            bytes += bytesFrom<std::uint32_t>({length});
        else if (isLong)
            bytes += vr + std::string(2, '\0') + bytesFrom<std::uint32_t>({length}, big);
        else
            bytes += vr + bytesFrom<std::uint16_t>({static_cast<std::uint16_t>(length)}, big);
        bytes += value;
        return *this;
    }
    Elements& word(std::uint16_t group, std::uint16_t element, std::uint16_t value) {
        return put(group, element, "US", bytesFrom<std::uint16_t>({value}, m_writing == bigSyntax));
    }
    /// Fragments, with an empty offset table.
    Elements& fragments(const std::vector<std::string>& fragments, const std::string& vr = "OB") {
        const bool big = m_writing == bigSyntax;
        const auto item = [&](std::uint16_t element, const std::string& value) {
            return bytesFrom<std::uint16_t>({0xfffe, element}, big) +
                   bytesFrom<std::uint32_t>({static_cast<std::uint32_t>(value.size())}, big) + value;
        };
        std::string all = item(0xe000, "");
        for (const std::string& fragment : fragments) all += item(0xe000, fragment);
        return put(0x7fe0, 0x0010, vr, all + item(0xe0dd, ""), true);
    }
    std::string bytes;

private:
    std::string m_writing;
};

std::string pixels() {
    std::string all;
    for (int i = 0; i < 24; ++i) all += static_cast<char>(10 + i);
    return all;
}

/// Three frames of 4 x 2 pixels, 1.5 mm apart, without their pixels.
Elements picture(const std::string& writing, const std::string& frames = "3") {
    Elements all(writing);
    all.put(0x0008, 0x0016, "UI", cineClass).put(0x0008, 0x0060, "CS", "US").put(0x0018, 0x0088, "DS", "1.5");
    all.word(0x0028, 0x0002, 1).put(0x0028, 0x0004, "CS", "MONOCHROME2").put(0x0028, 0x0008, "IS", frames);
    all.word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 4).put(0x0028, 0x0030, "DS", "0.5\\0.25");
    return all.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
}

std::string plain(const std::string& writing) { return picture(writing).put(0x7fe0, 0x0010, "OB", pixels()).bytes; }

std::string fileOf(const std::string& said, const std::string& dataset) {
    return DicomBytes().file("", said) + dataset;
}

/// A frame of eight pixels as RLE packs them.
std::string rleFrame(int frame) {
    const auto eight = pixels().substr(static_cast<std::size_t>(8 * frame), 8);
    std::string header = bytesFrom<std::uint32_t>({1, 64});
    header.resize(64, '\0');
    return header + '\x07' + eight + '\0';
}

std::vector<std::string> rleFrames() { return {rleFrame(0), rleFrame(1), rleFrame(2)}; }

Result<Study> readWritten(const std::string& bytes) {
    const TemporaryFolder folder;
    return readStudy(folder.write("a.dcm", bytes), withoutGuess());
}

std::string sentenceOf(const std::string& bytes) {
    const auto study = readWritten(bytes);
    return study ? "opens" : study.error().sentence();
}

/// Whether the pixels and their size are right; else what is wrong.
std::string wrongIn(const Result<Study>& study) {
    if (!study) return study.error().sentence();
    std::vector<double> right;
    for (int i = 0; i < 24; ++i) right.push_back(10 + i);
    if (storedValues(*study->phases[0]) != right) return "other voxels";
    return study->phases[0]->geometry().spacing == Vec3(0.25, 0.5, 1.5) ? "" : "another spacing";
}

TEST(DicomContradictions, ElementsAreReadAsTheyAreWrittenWhateverTheTransferSyntaxSays) {
    for (const std::string& held : writings)
        for (const std::string& said : {implicitSyntax, explicitSyntax, bigSyntax, deflatedSyntax}) {
            const auto study = readWritten(fileOf(said, plain(held)));
            ASSERT_EQ(wrongIn(study), "") << said << " " << held;
            EXPECT_EQ(warnsOf(*study, syntaxNote), said != held) << said << " " << held;
        }
}

TEST(DicomContradictions, FragmentsAreReadByTheirOwnBytesUnderASyntaxThatHasNone) {
    for (const std::string& held : writings)
        for (const std::string& said : {implicitSyntax, explicitSyntax, bigSyntax, rleSyntax}) {
            const auto study = readWritten(fileOf(said, picture(held).fragments(rleFrames()).bytes));
            ASSERT_EQ(wrongIn(study), "") << said << " " << held;
            EXPECT_EQ(warnsOf(*study, syntaxNote), said != rleSyntax || held != explicitSyntax) << said << held;
        }
}

TEST(DicomContradictions, EveryCodingIsKnownByItsFirstFragment) {
    TestImage image;
    image.columns = image.rows = 16;
    image.frames = 2;
    for (int i = 0; i < 512; ++i) image.pixels8.push_back(static_cast<std::uint8_t>(i / 4));
    image.pixelSpacing = {0.5, 0.25};
    image.spacingBetweenSlices = 1.5;
    const TemporaryFolder folder;
    std::map<std::string, TestSyntax> codings{{rleSyntax, TestSyntax::rle},
                                              {jpegLosslessSyntax, TestSyntax::jpegLossless},
                                              {jpegLsSyntax, TestSyntax::jpegLs}};
    for (const auto& [uid, syntax] : codings) {
        const std::string path = folder.file("a.dcm");
        writeDicom(path, image, syntax);
        std::string bytes = contentsOf(path);
        std::string said = explicitSyntax;
        said.resize(uid.size(), '\0');
        bytes.replace(bytes.find(uid), uid.size(), said);
        const auto study = readStudy(folder.write("b.dcm", bytes), withoutGuess());
        ASSERT_TRUE(study) << uid << study.error().sentence();
        EXPECT_EQ(storedValues(*study->phases[0]), std::vector<double>(image.pixels8.begin(), image.pixels8.end()));
        EXPECT_TRUE(warnsOf(*study, syntaxNote)) << uid;
    }
}

TEST(DicomContradictions, FragmentsOfNoCodingAndPlainPixelsUnderACodingAreRefusedByName) {
    for (const std::string& said : writings)
        EXPECT_THAT(sentenceOf(fileOf(said, picture(said).fragments({pixels()}).bytes)),
                    HasSubstr("(7fe0,0010) Pixel Data is split into fragments, which the transfer syntax"));
    EXPECT_THAT(sentenceOf(fileOf(rleSyntax, plain(explicitSyntax))), HasSubstr("is not split into fragments"));
}

TEST(DicomContradictions, FragmentsOfUnknownRepresentationAreRead) {
    const auto study = readWritten(fileOf(rleSyntax, picture(explicitSyntax).fragments(rleFrames(), "UN").bytes));
    EXPECT_EQ(wrongIn(study), "");
    EXPECT_TRUE(warnsOf(*study, "value representation UN"));
}

TEST(DicomContradictions, AFalseLengthOfTheMetaHeaderIsNoted) {
    for (const std::string& writing : writings) {
        const std::string bytes = fileOf(writing, plain(writing));
        EXPECT_FALSE(warnsOf(*readWritten(bytes), "(0002,0000)"));
        for (const std::uint32_t length : {0U, 1U, 20U, 30U, 4000U, 0x7fffffffU, 0xffffffffU}) {
            std::string changed = bytes;
            changed.replace(140, 4, bytesFrom<std::uint32_t>({length}));
            const auto study = readWritten(changed);
            ASSERT_EQ(wrongIn(study), "") << writing << " " << length;
            EXPECT_TRUE(warnsOf(*study, "(0002,0000) File Meta Information Group Length is false"));
        }
    }
}

/// Bytes that are no DICOM, but look like elements.
std::vector<std::string> noDicom() {
    const std::string openSequence = Elements(explicitSyntax).put(0xfffc, 0xfffc, "SQ", "", true).bytes;
    return {std::string(992, '\x55'),
            std::string("\x10\0\x20\0", 4) + std::string(500, '\x99'),
            Elements(explicitSyntax).put(0xfffc, 0xfffc, "OB", std::string(50, 'a')).bytes.substr(0, 20),
            openSequence + std::string("\xfe\xff\0\xe0\xff\xff\xff\xff", 8) + std::string(700, '\x41'),
            std::string(5000000, '\0'),
            std::string("\x55\x55\x55", 3)};
}

TEST(DicomContradictions, WhatStandsBehindThePixelsIsLeftOutEvenIfItLooksLikeALongElement) {
    for (const std::string& writing : writings)
        for (const std::string& behind : noDicom()) {
            const auto study = readWritten(fileOf(writing, plain(writing)) + behind);
            ASSERT_EQ(wrongIn(study), "") << writing << " " << behind.size();
            EXPECT_TRUE(warnsOf(*study, behindNote)) << writing << " " << behind.size();
        }
    const auto study =
        readWritten(fileOf(rleSyntax, picture(explicitSyntax).fragments(rleFrames()).bytes) + noDicom()[0]);
    EXPECT_EQ(wrongIn(study), "");
    EXPECT_FALSE(warnsOf(*readWritten(fileOf(explicitSyntax, plain(explicitSyntax))), behindNote));
}

TEST(DicomContradictions, WholeElementsBehindThePixelsAreStillRead) {
    const std::string whole = plain(explicitSyntax);
    const std::string padding = Elements(explicitSyntax).put(0xfffc, 0xfffc, "OB", std::string(50, 'a')).bytes;
    const auto study = readWritten(fileOf(explicitSyntax, whole + padding));
    EXPECT_EQ(wrongIn(study), "");
    EXPECT_FALSE(warnsOf(*study, behindNote));
}

TEST(DicomContradictions, RleFramesOfSeveralFragmentsAreToldApartByTheirHeaders) {
    std::vector<std::string> halves;
    for (const std::string& frame : rleFrames()) {
        halves.push_back(frame.substr(0, 66));
        halves.push_back(frame.substr(66));
    }
    EXPECT_EQ(wrongIn(readWritten(fileOf(rleSyntax, picture(explicitSyntax).fragments(halves).bytes))), "");
    halves.pop_back();
    EXPECT_NE(wrongIn(readWritten(fileOf(rleSyntax, picture(explicitSyntax).fragments(halves).bytes))), "");
}

TEST(DicomContradictions, EmptyFragmentsCountForNothing) {
    for (const std::size_t place : {0, 1, 3}) {
        auto fragments = rleFrames();
        fragments.insert(fragments.begin() + static_cast<std::ptrdiff_t>(place), "");
        const auto study = readWritten(fileOf(rleSyntax, picture(explicitSyntax).fragments(fragments).bytes));
        ASSERT_EQ(wrongIn(study), "") << place;
        EXPECT_TRUE(warnsOf(*study, "Empty fragments"));
    }
}

TEST(DicomContradictions, SeveralRlePicturesInOneFrameAreRefused) {
    EXPECT_THAT(sentenceOf(fileOf(rleSyntax, picture(explicitSyntax, "1").fragments(rleFrames()).bytes)),
                HasSubstr("holds 3 pictures where one is declared"));
}

}  // namespace
}  // namespace echolucent
