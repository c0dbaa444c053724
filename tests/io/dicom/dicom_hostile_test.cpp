// DICOM files that are made to cost memory or time, and faults that are put right: bounded, and said once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "dicom_bytes.h"
#include "io/dicom/elements/dicom_scan.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Pictures of 4 x 2 pixels, all equally far apart, of which only the first is there.
std::string framesThatAreNotThere(const std::string& count, bool encapsulated) {
    DicomBytes file;
    file.text(0x0018, 0x0088, "DS", "1").picture(4, 2, 0).text(0x0028, 0x0008, "IS", count);
    file.text(0x0028, 0x0030, "DS", "1\\1");
    if (!encapsulated) return file.put(0x7fe0, 0x0010, "OW", std::string(8, 'a')).file(cineClass);
    return file.fragments("", {"abcd"}).file(cineClass, rleSyntax);
}

TEST(HostileDicom, FramesThatTheFileCannotHoldAreNotLaidOutForTheList) {
    for (const char* count : {"10000000", "100000000", "999999999999"})
        for (const bool encapsulated : {false, true}) {
            const TemporaryFolder folder;
            folder.write("many", framesThatAreNotThere(count, encapsulated));
            folder.write("two", twoFrames().file(cineClass));
            const auto begun = std::chrono::steady_clock::now();
            const auto list = listSeries(folder.path());
            EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(1)) << count;
            ASSERT_TRUE(list) << list.error().sentence();
            ASSERT_EQ(list->series.size(), 2u);
            EXPECT_EQ(list->series[0].files[0].path, folder.file("two")) << "what can be opened comes first";
            EXPECT_FALSE(list->series[0].whyNot);
            ASSERT_TRUE(list->series[1].whyNot) << count;
            EXPECT_THAT(list->series[1].whyNot->sentence(), HasSubstr("many: (")) << "names the element";
        }
}

TEST(HostileDicom, ItemsOutsideSequencesAreSaidOnce) {
    const TemporaryFolder folder;
    const std::string item("\xfe\xff\x00\xe0\0\0\0\0", 8);
    const auto withItems = [&](int count) {
        std::string bytes = DicomBytes().text(0x0008, 0x0060, "CS", "US").file(cineClass);
        for (int i = 0; i < count; ++i) bytes += item;
        return folder.write("a.dcm", bytes + twoFrames().bytes());
    };
    const auto few = readStudy(withItems(500), withoutGuess());
    ASSERT_TRUE(few) << few.error().sentence();
    EXPECT_EQ(std::ranges::count_if(
                  few->warnings, [](const std::string& one) { return one.find("no sequence") != std::string::npos; }),
              1);
}

/// A sequence that is declared to be empty in front of `items`, with or without its delimiter.
std::string falselyEmpty(const std::string& items, bool delimiter) {
    DicomBytes file;
    file.put(0x0008, 0x2218, "SQ", "");
    return file.bytes() + items + (delimiter ? std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8) : "");
}

TEST(HostileDicom, ASequenceDeclaredEmptyMayHaveItemsAndItsDelimiter) {
    const std::string item = dicomItem(DicomBytes().text(0x0008, 0x0100, "SH", "CODE").bytes());
    for (const bool delimiter : {false, true}) {
        const TemporaryFolder folder;
        const std::string bytes =
            DicomBytes().file(cineClass) + falselyEmpty(item + item, delimiter) + twoFrames().bytes();
        const auto study = readStudy(folder.write("a.dcm", bytes), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence() << delimiter;
        EXPECT_EQ(study->phases[0]->storedValue(15), 'a');
        EXPECT_TRUE(warnsOf(*study, "declared to be empty although items follow"));
    }
}

TEST(HostileDicom, EachKindOfRepairIsSaid) {
    const TemporaryFolder folder;
    const std::string item = dicomItem(DicomBytes().text(0x0008, 0x0100, "SH", "CODE").bytes());
    const std::string bytes = DicomBytes().text(0x0008, 0x0060, "CS", "US").file(cineClass) + item +
                              falselyEmpty(item, false) + twoFrames().bytes();
    const auto study = readStudy(folder.write("a.dcm", bytes), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_TRUE(warnsOf(*study, "An item that belongs to no sequence is left out"));
    EXPECT_TRUE(warnsOf(*study, "declared to be empty although items follow"));
}

/// A data set of 300 MB of zeros in 300 KB.
std::string bomb() {
    DicomBytes file;
    file.text(0x0008, 0x0060, "CS", "US").put(0x0009, 0x1001, "OB", std::string(300 << 20, '\0'));
    return DicomBytes().file(cineClass, deflatedSyntax) + deflated(file.bytes() + twoFrames().bytes(), -15);
}

TEST(HostileDicom, DeflatedDataThatUnpackTooFarAreRefusedBeforeTheLibrarySeesThem) {
    const TemporaryFolder folder;
    const std::string path = folder.write("bomb.dcm", bomb());
    ASSERT_LT(std::filesystem::file_size(path), 1u << 20);
    const auto study = readStudy(path, withoutGuess());
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), AllOf(HasSubstr("unpacks to more than"), HasSubstr("which no volume does")));
    EXPECT_THAT(listSeries(folder.path()).error().sentence(), HasSubstr("unpacks to more than"));
    // One value of 300 MB takes seconds; it ends where the person does not want to wait.
    std::atomic<bool> cancel{true};
    const Progress progress{{}, &cancel};
    const auto begun = std::chrono::steady_clock::now();
    const auto scan = scanDicom(*InputFile::open(path), progress);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().kind, FailureKind::cancelled);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(1));
}

}  // namespace
}  // namespace echolucent
