// Values that DICOM does not know but programs write: decimal commas, 0 frames, a scout among the slices, slices of a
// kind that cannot be read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string commaNote = "holds a decimal comma";

/// What a slice of 4 x 3 pixels says in text.
struct SliceTexts {
    std::string orientation = "1\\0\\0\\0\\1\\0";
    std::string spacing = "0.5\\0.25";
    std::string slope, frames, centre, width;
    std::uint16_t bits = 8;
};

std::string sliceOf(const std::string& position, int instance, const SliceTexts& texts) {
    DicomBytes file;
    file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0013, "IS", std::to_string(instance));
    file.text(0x0020, 0x0032, "DS", position).text(0x0020, 0x0037, "DS", texts.orientation);
    file.text(0x0028, 0x0008, "IS", texts.frames).picture(4, 3, 0, texts.bits);
    if (!texts.spacing.empty()) file.text(0x0028, 0x0030, "DS", texts.spacing);
    if (!texts.centre.empty()) file.text(0x0028, 0x1050, "DS", texts.centre).text(0x0028, 0x1051, "DS", texts.width);
    if (!texts.slope.empty()) file.text(0x0028, 0x1052, "DS", "0,5").text(0x0028, 0x1053, "DS", texts.slope);
    std::string pixels;
    for (int i = 0; i < 12; ++i) {
        pixels += static_cast<char>(10 * instance + i);
        if (texts.bits == 16) pixels += '\0';
    }
    return file.put(0x7fe0, 0x0010, "OW", pixels).file(pictureClass);
}

/// Three slices whose positions are so written.
Result<Study> readSlices(const std::vector<std::string>& positions, const SliceTexts& texts) {
    const TemporaryFolder folder;
    for (std::size_t i = 0; i < positions.size(); ++i)
        folder.write(fmt::format("{}.dcm", i), sliceOf(positions[i], static_cast<int>(i), texts));
    return readStudy(folder.path(), withoutGuess());
}

const std::vector<std::string> withPoints{"0\\0\\0", "0\\0\\1.5", "0\\0\\3.0"};
const std::vector<std::string> withCommas{"0\\0\\0", "0\\0\\1,5", "0\\0\\3,0"};

TEST(DicomOddValues, ADecimalCommaIsReadAsAPointAndNotedOnce) {
    SliceTexts texts;
    texts.spacing = "0,5\\0,25";
    texts.orientation = "1,0\\0\\0\\0\\1,0\\0";
    texts.slope = "1,5";
    const auto study = readSlices(withCommas, texts);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.25, 0.5, 1.5));
    EXPECT_TRUE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(study->phases[0]->storedValue(13), 1.5 * 11 + 0.5);
    EXPECT_EQ(std::ranges::count_if(study->warnings,
                                    [](const auto& note) { return note.find(commaNote) != std::string::npos; }),
              1);
    EXPECT_FALSE(warnsOf(*readSlices(withPoints, {}), commaNote));
}

TEST(DicomOddValues, ADecimalCommaIsReadInAWindowAndInOneFileOfManyFrames) {
    SliceTexts texts;
    texts.bits = 16;
    texts.centre = "20,5";
    texts.width = "41,0";
    const auto study = readSlices(withPoints, texts);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_TRUE(warnsOf(*study, commaNote));
    EXPECT_FALSE(warnsOf(*study, "its numbers are no window"));
    DicomBytes file;
    file.text(0x0018, 0x0088, "DS", "1,25").picture(4, 2, 2).text(0x0028, 0x0030, "DS", "0,5\\0,75");
    const TemporaryFolder folder;
    const std::string bytes = file.put(0x7fe0, 0x0010, "OW", std::string(16, 'a')).file(cineClass);
    const auto frames = readStudy(folder.write("a.dcm", bytes), withoutGuess());
    ASSERT_TRUE(frames) << frames.error().sentence();
    EXPECT_EQ(frames->phases[0]->geometry().spacing, Vec3(0.75, 0.5, 1.25));
    EXPECT_TRUE(warnsOf(*frames, commaNote));
}

TEST(DicomOddValues, ASpacingThatIsStatedButNoNumberIsNamed) {
    for (const char* const spacing : {"0.7,0.6", "0.7;0.6", "1,000.5\\2", "wide\\high"}) {
        SliceTexts texts;
        texts.spacing = spacing;
        const auto study = readSlices(withPoints, texts);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
        EXPECT_TRUE(warnsOf(*study, "(0028,0030) Pixel Spacing is \"" + std::string(spacing) + "\"")) << spacing;
    }
}

TEST(DicomOddValues, APlaceThatIsStatedButMakesNoSenseIsNamed) {
    const auto commas = readSlices({"0,0,0", "0,0,1.5", "0,0,3.0"}, {});
    ASSERT_FALSE(commas);
    EXPECT_THAT(commas.error().sentence(), HasSubstr("(0020,0032) Image Position is \"0,0,0\", which is no position"));
    SliceTexts texts;
    texts.orientation = "1\\0\\0\\1\\0\\0";
    const auto skewed = readSlices(withPoints, texts);
    ASSERT_FALSE(skewed);
    EXPECT_THAT(skewed.error().sentence(), HasSubstr("(0020,0037) Image Orientation is \"1\\0\\0\\1\\0\\0\""));
}

TEST(DicomOddValues, NoFramesAreOneFrameIfThePixelsAreThoseOfOne) {
    SliceTexts texts;
    texts.frames = "0";
    const auto study = readSlices(withPoints, texts);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(13), 11.0);
    EXPECT_TRUE(warnsOf(*study, "(0028,0008) Number of Frames is 0; it was taken as 1."));
    DicomBytes two;
    two.text(0x0018, 0x0088, "DS", "1").text(0x0028, 0x0008, "IS", "0").picture(4, 2, 0);
    two.text(0x0028, 0x0030, "DS", "1\\1").put(0x7fe0, 0x0010, "OW", std::string(16, 'a'));
    const TemporaryFolder folder;
    EXPECT_FALSE(readStudy(folder.write("a.dcm", two.file(cineClass)), framesAsSlices()));
}

TEST(DicomOddValues, AScoutAmongTheSlicesIsListedApart) {
    for (const int scouts : {1, 2}) {
        const TemporaryFolder folder;
        SliceTexts across;
        across.orientation = "1\\0\\0\\0\\0\\-1";
        for (int i = 0; i < scouts; ++i) folder.write(fmt::format("a{}", i), sliceOf("0\\0\\0", i, across));
        for (int i = 0; i < 4; ++i)
            folder.write(fmt::format("b{}", i), sliceOf(fmt::format("0\\0\\{}", 2 * i), 5 + i, {}));
        const auto study = readStudy(folder.path(), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->geometry().size[2], 4);
        EXPECT_EQ(study->phases[0]->storedValue(0), 50.0);
        EXPECT_TRUE(warnsOf(*study, "are of 2 orientations; they are listed apart"));
    }
}

TEST(DicomOddValues, ASweepThatTurnsLittleByLittleStaysRefused) {
    const TemporaryFolder folder;
    for (int i = 0; i < 9; ++i) {
        SliceTexts turned;
        const double angle = 0.02 * (i / 3);
        turned.orientation = fmt::format("1\\0\\0\\0\\{:.9f}\\{:.9f}", std::cos(angle), std::sin(angle));
        folder.write(fmt::format("s{}", i), sliceOf(fmt::format("0\\0\\{}", i), i, turned));
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("freehand sweep"));
}

TEST(DicomOddValues, SlicesOfAKindThatCannotBeReadAreNotCalledDamagedAndKeepTheirAdvice) {
    DicomBytes bit;
    bit.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    const TemporaryFolder bits, coded;
    for (int i = 0; i < 3; ++i) {
        DicomBytes one = bit;
        one.text(0x0020, 0x0032, "DS", fmt::format("0\\0\\{}", i)).picture(8, 8, 0, 1);
        bits.write(fmt::format("s{}", i), one.put(0x7fe0, 0x0010, "OB", std::string(8, 'a')).file(pictureClass));
        const std::string whole = sliceOf(fmt::format("0\\0\\{}", i), i, {});
        const std::string dataset = whole.substr(DicomBytes().file(pictureClass).size());
        coded.write(fmt::format("s{}", i), DicomBytes().file(pictureClass, "1.2.840.10008.1.2.4.94") + dataset);
    }
    const auto ofBits = readStudy(bits.path());
    ASSERT_FALSE(ofBits);
    EXPECT_THAT(ofBits.error().sentence(), AllOf(HasSubstr("3 of 3 slices could not be read"),
                                                 HasSubstr("(0028,0100) Bits Allocated is 1; only 8 and 16"),
                                                 HasSubstr("Export it again as 8- or 16-bit grey or colour.")));
    EXPECT_THAT(ofBits.error().sentence(), testing::Not(HasSubstr("damaged")));
    const auto ofCoding = readStudy(coded.path());
    ASSERT_FALSE(ofCoding);
    EXPECT_THAT(ofCoding.error().sentence(),
                AllOf(HasSubstr("(0002,0010) Transfer Syntax is"), HasSubstr("Save it uncompressed")));
    EXPECT_THAT(ofCoding.error().sentence(), testing::Not(HasSubstr("damaged")));
}

}  // namespace
}  // namespace echolucent
