// Objects of many frames that are kept in several files: joined in their order, or the missing part is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A part of an object of frames of 2 x 2 pixels; pixel values are 1 + the frame's number in the whole object, and so
/// many times 1.5 mm is its place.
struct Part {
    int number = 1, first = 0, frames = 2;
    int total = 0;       ///< 0: not stated
    bool offset = true;  ///< whether the offset is stated
    double spacing = 0.5;
    std::uint16_t rows = 2;
    std::string whole = "1.2.8";
    std::string syntax = "1.2.840.10008.1.2.1";
    std::string object{};
    std::string intercept{};

    [[nodiscard]] std::string bytes() const {
        const auto sequence = [](std::uint16_t group, std::uint16_t element, const DicomBytes& item) {
            return DicomBytes().sequence(group, element, {item});
        };
        std::vector<DicomBytes> groups;
        std::string pixels;
        for (int frame = first; frame < first + frames; ++frame) {
            groups.push_back(
                sequence(0x0020, 0x9113, DicomBytes().text(0x0020, 0x0032, "DS", fmt("0\\0\\", 1.5 * frame))));
            pixels += std::string(static_cast<std::size_t>(2 * rows), static_cast<char>(1 + frame));
        }
        DicomBytes shared = sequence(0x0020, 0x9116, DicomBytes().text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0"));
        const DicomBytes measures = DicomBytes().text(0x0028, 0x0030, "DS", fmt("", spacing) + fmt("\\", spacing));
        shared.sequence(0x0028, 0x9110, {measures});
        DicomBytes file;
        file.text(0x0008, 0x0018, "UI", object.empty() ? "1.2.3.1." + std::to_string(number) : object);
        file.text(0x0020, 0x000e, "UI", "1.2.3");
        if (!whole.empty()) file.text(0x0020, 0x9161, "UI", whole);
        if (number >= 0) file.word(0x0020, 0x9162, static_cast<std::uint16_t>(number));
        if (total > 0) file.word(0x0020, 0x9163, static_cast<std::uint16_t>(total));
        if (offset) file.put(0x0020, 0x9228, "UL", bytesFrom<std::uint32_t>({static_cast<std::uint32_t>(first)}));
        file.picture(2, rows, frames);
        if (!intercept.empty()) file.text(0x0028, 0x1052, "DS", intercept).text(0x0028, 0x1053, "DS", "1");
        file.sequence(0x5200, 0x9229, {shared}).sequence(0x5200, 0x9230, groups);
        if (syntax == rleSyntax) {
            std::vector<std::string> fragments;
            for (int frame = 0; frame < frames; ++frame) {
                std::string segment = bytesFrom<std::uint32_t>({1, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
                segment += static_cast<char>(1 - 2 * rows);
                segment += static_cast<char>(1 + first + frame);
                fragments.push_back(segment);
            }
            file.fragments("", fragments);
        } else {
            file.put(0x7fe0, 0x0010, "OB", pixels);
        }
        return file.file("1.2.840.10008.5.1.4.1.1.2.1", syntax);
    }

private:
    static std::string fmt(const std::string& before, double value) {
        return before + std::to_string(value).substr(0, std::to_string(value).find('.') + 3);
    }
};

Part partOf(int number, int first, int frames, int total = 0) {
    Part part;
    part.number = number;
    part.first = first;
    part.frames = frames;
    part.total = total;
    return part;
}

/// Requires that the study is the whole object of this many frames.
void expectWhole(const Result<Study>& study, int frames) {
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 1u);
    const Volume& volume = *study->phases[0];
    ASSERT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{2, 2, frames}));
    EXPECT_EQ(volume.geometry().spacing, Vec3(0.5, 0.5, 1.5));
    for (std::int64_t frame = 0; frame < frames; ++frame)
        EXPECT_EQ(volume.storedValue(4 * frame), static_cast<double>(frame + 1));
}

std::string refusalOf(const TemporaryFolder& folder) {
    const auto study = readStudy(folder.path());
    return study ? "opened" : study.error().sentence();
}

TEST(Concatenation, PartsOfAFolderAreJoinedInTheirOrder) {
    const TemporaryFolder folder;
    folder.write("a", partOf(3, 5, 1, 3).bytes());  // a part of one frame
    folder.write("b", partOf(1, 0, 2, 3).bytes());
    folder.write("c", partOf(2, 2, 3, 3).bytes());
    const auto study = readStudy(folder.path(), withoutGuess());
    expectWhole(study, 6);
    EXPECT_TRUE(warnsOf(*study, "3 files are the parts of one object (a concatenation) and were joined."));
    EXPECT_EQ(study->files.size(), 3u);
    const auto list = listSeries(folder.path());
    ASSERT_EQ(list->series.size(), 1u);
    EXPECT_EQ(list->series[0].uid, "1.2.3");
    EXPECT_EQ(sizeInWords(list->series[0]), "2 x 2, 6 frames");
    EXPECT_TRUE(middlePicture(list->series[0], 10));
    const std::string directory = folder.write("DICOMDIR", dicomDirectory({"A", "B", "C"}));
    expectWhole(readStudy(directory, withoutGuess()), 6);
}

TEST(Concatenation, APartByItselfSaysThatItIsOne) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", partOf(1, 0, 2, 2).bytes());
    EXPECT_THAT(readStudy(path).error().sentence(), AllOf(HasSubstr("says that the file is part 1 of 2 of one object"),
                                                          HasSubstr("Open the folder that holds all parts.")));
    folder.write("a", partOf(1, 0, 2, 1).bytes());
    expectWhole(readStudy(path, withoutGuess()), 2);
}

TEST(Concatenation, WhatMayBeWholeOpens) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", partOf(1, 0, 2).bytes());
    for (const std::string& opened : {path, folder.path()}) {
        const auto study = readStudy(opened, withoutGuess());
        expectWhole(study, 2);
        EXPECT_TRUE(warnsOf(*study, "1 part(s) are here, and more may be missing at the end"));
    }
    Part named = partOf(-1, 0, 2);
    named.offset = false;
    folder.write("a", named.bytes());
    for (const std::string& opened : {path, folder.path()}) {
        const auto study = readStudy(opened, withoutGuess());
        expectWhole(study, 2);
        EXPECT_FALSE(warnsOf(*study, "more may be missing")) << "a Concatenation UID by itself says nothing";
    }
}

TEST(Concatenation, PlainSlicesThatCallThemselvesPartsStaySlices) {
    const TemporaryFolder folder;
    for (int depth = 0; depth < 4; ++depth) {
        DicomBytes file;
        file.text(0x0008, 0x0018, "UI", "1.2.3." + std::to_string(depth)).text(0x0020, 0x000e, "UI", "1.2.3");
        file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth));
        file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").text(0x0020, 0x9161, "UI", "1.2.8");
        file.word(0x0020, 0x9162, static_cast<std::uint16_t>(depth + 1)).word(0x0020, 0x9163, 4);
        file.text(0x0028, 0x0030, "DS", "1\\1");
        DicomBytes pixels;
        pixels.picture(4, 2, 0).put(0x7fe0, 0x0010, "OW", std::string(8, static_cast<char>(1 + depth)));
        folder.write(std::to_string(depth), file.file(pictureClass) + pixels.bytes());
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{4, 2, 4}));
    EXPECT_EQ(study->phases[0]->storedValue(24), 4);
}

TEST(Concatenation, AMissingPartIsNamed) {
    const TemporaryFolder folder;
    folder.write("a", partOf(1, 0, 2, 4).bytes());
    folder.write("c", partOf(3, 4, 2, 4).bytes());
    EXPECT_THAT(refusalOf(folder),
                AllOf(HasSubstr("(0020,9162) In-concatenation Number shows that part 2, 4 of 4 of one "
                                "object is missing; here are only \"a\", \"c\""),
                      HasSubstr("Copy all parts into one folder and open that.")));
    const std::string cut = partOf(2, 2, 2, 4).bytes();
    folder.write("b", cut.substr(0, cut.size() - 3));
    EXPECT_THAT(refusalOf(folder), HasSubstr("1 file(s) beside it could not be read: \"b\""));
    std::filesystem::remove(folder.file("b"));
    // Without a total, a gap in the numbers or in the frames still shows it.
    folder.write("a", partOf(1, 0, 2).bytes());
    folder.write("c", partOf(3, 4, 2).bytes());
    EXPECT_THAT(refusalOf(folder), HasSubstr("part 2 of 3 of one object is missing"));
    folder.write("c", partOf(2, 4, 2).bytes());
    EXPECT_THAT(refusalOf(folder), HasSubstr("frames 3 to 4 of one object are missing: \"c\" begins behind them"));
}

TEST(Concatenation, WhatIsNotStatedIsAssumedAndNoted) {
    const TemporaryFolder folder;
    folder.write("a", partOf(1, 0, 2).bytes());
    folder.write("b", partOf(2, 2, 2).bytes());
    auto study = readStudy(folder.path(), withoutGuess());
    expectWhole(study, 4);
    EXPECT_TRUE(warnsOf(*study, "do not say of how many parts"));
    // Counted from 0.
    folder.write("a", partOf(0, 0, 2, 2).bytes());
    folder.write("b", partOf(1, 2, 2, 2).bytes());
    study = readStudy(folder.path(), withoutGuess());
    expectWhole(study, 4);
    EXPECT_TRUE(warnsOf(*study, "counted from 0"));
    // Totals disagree; offsets are missing.
    Part first = partOf(1, 0, 2, 1), second = partOf(2, 2, 2, 2);
    first.offset = second.offset = false;
    folder.write("a", first.bytes());
    folder.write("b", second.bytes());
    study = readStudy(folder.path(), withoutGuess());
    expectWhole(study, 4);
    EXPECT_TRUE(warnsOf(*study, "disagree on how many parts"));
    EXPECT_TRUE(warnsOf(*study, "(0020,9228) Concatenation Frame Offset Number is missing in some files"));
    // Numbers are missing.
    first = partOf(-1, 2, 2);
    second = partOf(-1, 0, 2);
    first.object = "1.2.3.7";
    folder.write("a", first.bytes());
    folder.write("b", second.bytes());
    expectWhole(readStudy(folder.path(), withoutGuess()), 4);
}

TEST(Concatenation, PartsMayHaveOtherCodingsButNoOtherSizes) {
    const TemporaryFolder folder;
    Part second = partOf(2, 2, 3, 2);
    second.syntax = rleSyntax;
    folder.write("a", partOf(1, 0, 2, 2).bytes());
    folder.write("b", second.bytes());
    const auto study = readStudy(folder.path(), withoutGuess());
    expectWhole(study, 5);
    EXPECT_EQ(factOf(*study, "transfer syntax"), "Little Endian Explicit, RLE Lossless");
    second.rows = 3;
    folder.write("b", second.bytes());
    EXPECT_THAT(refusalOf(folder), HasSubstr("\"b\""));
    second.rows = 2;
    second.spacing = 0.7;
    folder.write("b", second.bytes());
    EXPECT_THAT(refusalOf(folder), HasSubstr("(0028,0030) Pixel Spacing changes from frame to frame"))
        << "each frame keeps the groups of its part";
}

TEST(Concatenation, PartsMayBeRescaledDifferently) {
    const TemporaryFolder folder;
    Part second = partOf(2, 2, 3, 2);
    second.intercept = "-100";
    folder.write("a", partOf(1, 0, 2, 2).bytes());
    folder.write("b", second.bytes());
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->valueWindow(), (ValueWindow{-100, 255}));
    EXPECT_EQ(study->phases[0]->fileValue(0), 1);
    EXPECT_EQ(study->phases[0]->fileValue(16), -95);
}

TEST(Concatenation, TheSamePartTwiceIsACopyOrRefused) {
    const TemporaryFolder folder;
    folder.write("a", partOf(1, 0, 2, 2).bytes());
    folder.write("b", partOf(2, 2, 2, 2).bytes());
    folder.write("b again", partOf(2, 2, 2, 2).bytes());
    const auto study = readStudy(folder.path(), withoutGuess());
    expectWhole(study, 4);
    EXPECT_TRUE(warnsOf(*study, "1 file(s) are copies of others"));
    Part other = partOf(2, 2, 2, 2);
    other.object = "1.2.3.9";
    folder.write("b again", other.bytes());
    EXPECT_THAT(refusalOf(folder), HasSubstr("is 2 in two different files: \"b\", \"b again\""));
}

TEST(Concatenation, TwoObjectsOfOneSeriesStayApart) {
    const TemporaryFolder folder;
    for (const std::string whole : {"1.2.8", "1.2.9"})
        for (const int number : {1, 2}) {
            Part part = partOf(number, 2 * number - 2, 2, 2);
            part.whole = whole;
            part.object = whole + "." + std::to_string(number);
            folder.write(part.object, part.bytes());
        }
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 2u);
    for (const SeriesEntry& entry : list->series) {
        EXPECT_FALSE(entry.whyNot);
        EXPECT_EQ(entry.files.size(), 2u);
        expectWhole(readSeries(*list, entry, withoutGuess()), 4);
    }
}

}  // namespace
}  // namespace echolucent
