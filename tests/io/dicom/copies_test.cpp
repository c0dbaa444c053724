// Copies of DICOM files beside each other: left out, or refused if they differ.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A slice of 4 x 2 pixels of `value` at this depth.
std::string copiedSlice(int depth, char value, const std::string& uid = "", const std::string& spacing = "1\\1") {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", uid.empty() ? "1.2.3." + std::to_string(depth) : uid);
    file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0013, "IS", std::to_string(depth));
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth)).text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    file.text(0x0028, 0x0030, "DS", spacing);
    DicomBytes pixels;
    pixels.picture(4, 2, 0).put(0x7fe0, 0x0010, "OW", std::string(8, value));
    return file.file(pictureClass) + pixels.bytes();
}

/// The same slice run-length coded.
std::string packedSlice(int depth, char value) {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", "1.2.3." + std::to_string(depth));
    file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0013, "IS", std::to_string(depth));
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth)).text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    file.text(0x0028, 0x0030, "DS", "1\\1").picture(4, 2, 0);
    std::string segment = bytesFrom<std::uint32_t>({1, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    segment += std::string{static_cast<char>(-7), value};
    return file.fragments("", {segment}).file(pictureClass, rleSyntax);
}

void writeFour(const TemporaryFolder& folder) {
    for (int depth = 0; depth < 4; ++depth)
        folder.write("s" + std::to_string(depth), copiedSlice(depth, static_cast<char>('a' + depth)));
}

void expectFour(const Result<Study>& study) {
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases[0]->geometry().size[2], 4);
    for (std::int64_t depth = 0; depth < 4; ++depth)
        EXPECT_EQ(study->phases[0]->storedValue(8 * depth), static_cast<double>('a' + depth));
}

TEST(Copies, OfSlicesAreLeftOutWithANote) {
    const TemporaryFolder folder;
    writeFour(folder);
    folder.write("s1 (copy)", copiedSlice(1, 'b'));
    std::string preamble = copiedSlice(2, 'c');
    preamble.replace(0, 9, "elsewhere");
    folder.write("renamed.dcm", preamble);
    folder.write("packed.dcm", packedSlice(3, 'd'));
    const auto study = readStudy(folder.path(), withoutGuess());
    expectFour(study);
    EXPECT_TRUE(warnsOf(*study,
                        "3 file(s) are copies of others, which show the same at the same place and time, and were left "
                        "out: \"packed.dcm\", \"renamed.dcm\", \"s1 (copy)\"."));
    EXPECT_EQ(study->files.size(), 7u) << "none of them may be written over";
}

TEST(Copies, ThatDifferAreRefusedByName) {
    const TemporaryFolder folder;
    writeFour(folder);
    folder.write("s1 (copy)", copiedSlice(1, 'x'));
    EXPECT_THAT(
        readStudy(folder.path()).error().sentence(),
        AllOf(HasSubstr("(0008,0018) SOP Instance UID is the same in two files that differ, \"s1\", \"s1 (copy)\""),
              HasSubstr("Take away the one that does not belong here.")));
    folder.write("s1 (copy)", packedSlice(1, 'x'));
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("two files that differ"));
}

TEST(Copies, OfOtherPlacesAreOtherPictures) {
    const TemporaryFolder folder;
    writeFour(folder);
    folder.write("s4", copiedSlice(4, 'b', "1.2.3.1"));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 5);
    EXPECT_TRUE(warnsOf(*study,
                        "2 files share the (0008,0018) SOP Instance UID of another, though they lie elsewhere: \"s1\", "
                        "\"s4\"."));
}

TEST(Copies, MayWriteNumbersInAnotherWay) {
    const TemporaryFolder folder;
    writeFour(folder);
    folder.write("exported again", copiedSlice(1, 'b', "", "1.0\\1.00"));
    const auto study = readStudy(folder.path(), withoutGuess());
    expectFour(study);
    EXPECT_TRUE(warnsOf(*study, "1 file(s) are copies of others"));
}

TEST(Copies, AnIdentityThatAllPicturesShareIsNone) {
    const TemporaryFolder folder;
    for (int depth = 0; depth < 4; ++depth)
        folder.write("s" + std::to_string(depth), copiedSlice(depth, static_cast<char>('a' + depth), "1.2.3.9"));
    folder.write("t2", copiedSlice(2, 'c', "1.2.3.9"));
    const auto study = readStudy(folder.path(), withoutGuess());
    expectFour(study);
    EXPECT_TRUE(warnsOf(*study, "All pictures have the same (0008,0018) SOP Instance UID"));
    EXPECT_TRUE(warnsOf(*study, "1 file(s) are copies of others"));
}

TEST(Copies, OfAnotherIdentityAreLeftOutToo) {
    const TemporaryFolder folder;
    writeFour(folder);
    folder.write("sent again", copiedSlice(1, 'b', "1.2.4.77"));
    const auto study = readStudy(folder.path(), withoutGuess());
    expectFour(study);
    EXPECT_TRUE(warnsOf(*study, "left out: \"sent again\""));
    folder.write("sent again", copiedSlice(1, 'c', "1.2.4.77"));
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("Image Position is the same for two slices"));
}

TEST(Copies, AWholeOneStandsInForOneThatDoesNotDecode) {
    const TemporaryFolder folder;
    writeFour(folder);
    std::string broken = packedSlice(3, 'd');
    broken[broken.size() - 74] = 9;  // more segments than there are bytes
    folder.write("s", broken);
    const auto study = readStudy(folder.path(), withoutGuess());
    expectFour(study);
    EXPECT_TRUE(warnsOf(
        *study, "1 file(s) that cannot be decoded were left out, as others stand for the same picture: \"s\"."));
    EXPECT_FALSE(warnsOf(*study, "show the same"));
}

TEST(Copies, OfObjectsOfManyFramesAreLeftOutToo) {
    const TemporaryFolder folder;
    const DicomBytes object = twoFrames();
    const std::string bytes = DicomBytes().text(0x0008, 0x0018, "UI", "1.2.3.4").bytes();
    std::string file = object.file(cineClass);
    const std::size_t start = file.size() - object.bytes().size();
    file.insert(start, bytes);
    folder.write("a", file);
    folder.write("b", file);
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_TRUE(warnsOf(*study, "1 file(s) are copies of others"));
    EXPECT_EQ(listSeries(folder.path())->series.size(), 1u);
    file.back() = '\x7f';
    folder.write("b", file);
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("two files that differ, \"a\", \"b\""));
}

}  // namespace
}  // namespace echolucent
