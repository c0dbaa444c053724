// The series of folders and DICOMDIRs: listed, chosen, shown small, read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "io/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string pictureClass = "1.2.840.10008.5.1.4.1.1.6.1";

/// A slice of 4 x 2 pixels at this depth.
std::string slice(const std::string& series, int depth, const std::string& description = "", int columns = 4) {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", series + "." + std::to_string(depth)).text(0x0008, 0x0060, "CS", "US");
    if (!description.empty()) file.text(0x0008, 0x103e, "LO", description);
    file.text(0x0010, 0x0010, "PN", "Muster^Anna").text(0x0010, 0x0020, "LO", "P-4711");
    file.text(0x0020, 0x000e, "UI", series).text(0x0020, 0x0013, "IS", std::to_string(depth));
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth)).text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    DicomBytes pixels;
    pixels.picture(static_cast<std::uint16_t>(columns), 2, 0);
    std::string grey(static_cast<std::size_t>(2 * columns), static_cast<char>(10 * depth));
    pixels.put(0x7fe0, 0x0010, "OW", grey);
    DicomBytes whole;
    return file.file(pictureClass) + pixels.bytes();
}

std::string cine(const std::string& series) {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", series + ".77").text(0x0008, 0x0060, "CS", "US").text(0x0020, 0x000e, "UI", series);
    return file.picture(4, 2, 9).put(0x7fe0, 0x0010, "OW", std::string(72, 'a')).file("1.2.840.10008.5.1.4.1.1.3.1");
}

/// Three slices of one series, two of another, and a cine of nine frames.
void writeThreeSeries(const TemporaryFolder& folder) {
    for (const int depth : {2, 1, 3}) folder.write("a" + std::to_string(depth), slice("1.2.3", depth, "long axis"));
    for (const int depth : {1, 2}) folder.write("b" + std::to_string(depth), slice("1.2.4", depth, "", 6));
    folder.write("c", cine("1.2.5"));
    folder.write("notes.txt", "no DICOM at all");
}

TEST(SeriesList, HoldsWhatAPersonChoosesFrom) {
    const TemporaryFolder folder;
    writeThreeSeries(folder);
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 3u);
    const SeriesEntry& first = list->series[0];
    EXPECT_EQ(first.uid, "1.2.3");
    EXPECT_EQ(first.description, "long axis");
    EXPECT_EQ(first.modality, "US");
    EXPECT_EQ(first.size, (std::array<std::int64_t, 3>{4, 2, 3}));
    EXPECT_FALSE(first.multiframe);
    EXPECT_FALSE(first.whyNot);
    EXPECT_EQ(first.files[0].path, folder.file("a1")) << "in the order of the slices";
    EXPECT_EQ(first.files[2].path, folder.file("a3"));
    EXPECT_EQ(list->series[1].uid, "1.2.4");
    const SeriesEntry& last = list->series[2];
    EXPECT_TRUE(last.multiframe) << "what cannot be opened comes last, however many frames it has";
    EXPECT_EQ(last.size[2], 9);
    ASSERT_TRUE(last.whyNot);
    EXPECT_TRUE(last.whyNot->framesCouldBeSlices);
    EXPECT_THAT(last.whyNot->sentence(), HasSubstr("is a 2D cine of 9 frames"));
    EXPECT_EQ(list->files.size(), 6u);
}

TEST(SeriesList, ADescriptionThatNamesThePatientIsLeftOut) {
    const TemporaryFolder folder;
    for (const char* text : {"Scan of MUSTER", "anna, fetus 2", "id p-4711"}) {
        folder.write("a", slice("1.2.3", 1, text));
        EXPECT_EQ(listSeries(folder.path())->series[0].description, "") << text;
    }
    folder.write("a", slice("1.2.3", 1, "fetal heart"));
    EXPECT_EQ(listSeries(folder.path())->series[0].description, "fetal heart");
}

TEST(SeriesList, TheChosenOneIsRead) {
    const TemporaryFolder folder;
    writeThreeSeries(folder);
    ReadOptions options = withoutGuess();
    EXPECT_EQ(readStudy(folder.path(), options)->phases[0]->geometry().size[2], 3);
    options.series = "1.2.4";
    const auto chosen = readStudy(folder.path(), options);
    ASSERT_TRUE(chosen) << chosen.error().sentence();
    EXPECT_EQ(chosen->phases[0]->geometry().size, (std::array<std::int64_t, 3>{6, 2, 2}));
    EXPECT_EQ(chosen->files.size(), 6u) << "no output may be any file of the folder";
    options.series = "1.2.5";
    EXPECT_THAT(readStudy(folder.path(), options).error().sentence(), HasSubstr("is a 2D cine"));
    options.framesAsSlices = true;
    EXPECT_EQ(readStudy(folder.path(), options)->phases[0]->geometry().size[2], 9);
    options.series = "1.2.9";
    EXPECT_THAT(readStudy(folder.path(), options).error().sentence(),
                AllOf(HasSubstr("holds no series \"1.2.9\""), HasSubstr("It holds \"1.2.3\", \"1.2.4\", \"1.2.5\".")));
}

TEST(SeriesList, AListedSeriesIsReadWithoutLookingAtTheFolderAgain) {
    const TemporaryFolder folder;
    writeThreeSeries(folder);
    const auto list = listSeries(folder.path());
    folder.write("a4", slice("1.2.3", 4));
    std::filesystem::remove(folder.file("b1"));
    const auto study = readSeries(*list, list->series[0], withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0])[16], 30);
    EXPECT_EQ(study->phases[0]->geometry().size[2], 3);
    const auto gone = readSeries(*list, list->series[1], withoutGuess());
    ASSERT_FALSE(gone);
    EXPECT_THAT(gone.error().sentence(), HasSubstr("could not be opened"));
}

TEST(SeriesList, EntriesThatShareASeriesHaveNamesOfTheirOwn) {
    const TemporaryFolder folder;
    for (const int depth : {1, 2, 3}) folder.write("a" + std::to_string(depth), slice("1.2.3", depth));
    for (const int depth : {1, 2}) folder.write("b" + std::to_string(depth), slice("1.2.3", depth, "", 6));
    folder.write("c", cine("1.2.3"));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list);
    std::vector<std::string> uids;
    for (const SeriesEntry& entry : list->series) uids.push_back(entry.uid);
    EXPECT_THAT(uids, ElementsAre("1.2.3", "1.2.3:6x2", "1.2.3.77"));
    for (const SeriesEntry& entry : list->series) EXPECT_EQ(*findSeries(*list, entry.uid), &entry);
}

TEST(SeriesList, AVolumeBehindThePixelsIsNoSinglePicture) {
    const TemporaryFolder folder;
    DicomBytes volume;
    volume.text(0x7fe1, 0x0010, "LO", "KRETZ_US").put(0x7fe1, 0x1001, "OB", "KRETZFILE 1.0   ");
    folder.write("a", slice("1.2.3", 1) + volume.bytes());
    folder.write("b", slice("1.2.3", 2));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 2u);
    EXPECT_FALSE(list->series[0].whyNot);
    EXPECT_EQ(list->series[0].files[0].path, folder.file("a"));
    EXPECT_THAT(list->series[1].whyNot->sentence(), HasSubstr("is a single 2D picture"));
}

TEST(SeriesList, TheMiddlePictureIsSmall) {
    const TemporaryFolder folder;
    for (const int depth : {1, 2, 3}) folder.write(std::to_string(depth), slice("1.2.3", depth, "", 40));
    const auto list = listSeries(folder.path());
    const auto picture = middlePicture(list->series[0], 10);
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->width, 10);
    EXPECT_EQ(picture->height, 1);
    EXPECT_EQ(picture->grey, std::vector<std::uint8_t>(10, 255));
}

TEST(SeriesList, SaysWhyItIsEmpty) {
    const TemporaryFolder folder;
    EXPECT_THAT(listSeries(folder.path()).error().sentence(), HasSubstr("is a folder without DICOM images"));
    folder.write("a", slice("1.2.3", 1).substr(0, 400));
    EXPECT_THAT(listSeries(folder.path()).error().sentence(), HasSubstr("/a: "));
}

TEST(SeriesList, CancelEndsItWithinAFileAThread) {
    const TemporaryFolder folder;
    for (int i = 0; i < 200; ++i) folder.write(std::to_string(i), slice("1.2.3", i));
    std::atomic<bool> cancel{false};
    int reports = 0;
    const Progress progress{[&](double) {
                                ++reports;
                                cancel = true;
                            },
                            &cancel};
    const auto list = listSeries(folder.path(), progress);
    ASSERT_FALSE(list);
    EXPECT_EQ(list.error().kind, FailureKind::cancelled);
    // A thread that has begun a file may report it.
    EXPECT_LE(reports, 1 + static_cast<int>(std::thread::hardware_concurrency()));
    reports = 0;
    EXPECT_FALSE(listSeries(folder.path(), progress));
    EXPECT_EQ(reports, 0) << "no file is begun once it is cancelled";
}

/// A DICOMDIR whose records name these files; each record links to itself.
std::string directory(const std::vector<std::string>& names) {
    std::vector<DicomBytes> records;
    for (const std::string& name : names) {
        DicomBytes record;
        record.put(0x0004, 0x1400, "UL", bytesFrom<std::uint32_t>({400}));
        record.word(0x0004, 0x1410, 0xffff).put(0x0004, 0x1420, "UL", bytesFrom<std::uint32_t>({400}));
        record.text(0x0004, 0x1430, "CS", "IMAGE").text(0x0004, 0x1500, "CS", name);
        records.push_back(record);
    }
    return DicomBytes().sequence(0x0004, 0x1220, records).file("1.2.840.10008.1.3.10");
}

TEST(DicomDirectory, OpensAsTheFilesThatItNames) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("images/series"));
    for (const int depth : {1, 2, 3}) folder.write("images/series/im" + std::to_string(depth), slice("1.2.3", depth));
    for (const int depth : {1, 2, 3, 4}) folder.write("other" + std::to_string(depth), slice("1.2.4", depth));
    const std::string path = folder.write(
        "DICOMDIR", directory({"IMAGES\\SERIES\\IM1", "IMAGES\\SERIES\\IM2", "IMAGES\\SERIES\\IM3", "IMAGES\\GONE"}));
    EXPECT_TRUE(holdsSeries(path));
    EXPECT_TRUE(holdsSeries(folder.path()));
    EXPECT_FALSE(holdsSeries(folder.file("other1")));
    const auto list = listSeries(path);
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 1u);
    EXPECT_EQ(list->series[0].uid, "1.2.3");
    EXPECT_THAT(list->warnings, ElementsAre(HasSubstr("1 of 4 files that the DICOMDIR names are not in its folder")));
    const auto study = readStudy(path, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 3);
    EXPECT_EQ(study->files[0], path) << "it is not to be overwritten either";
    EXPECT_EQ(listSeries(folder.path())->series.size(), 2u) << "a folder is what lies in it";
}

TEST(DicomDirectory, NamesThatLeadOutOfItsFolderAreMissing) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("in"));
    folder.write("secret", slice("1.2.3", 1));
    const std::string path =
        folder.write("in/DICOMDIR", directory({"..\\SECRET", folder.file("secret"), "/etc/passwd", "IN\\..\\..\\SECRET",
                                               "", "A\\\\B", std::string(200, 'X')}));
    const auto list = listSeries(path);
    ASSERT_FALSE(list);
    EXPECT_THAT(list.error().sentence(),
                HasSubstr("is a DICOMDIR, and none of the 6 files that it names is in its folder or below it"));
    EXPECT_THAT(readStudy(path).error().sentence(), HasSubstr("is a DICOMDIR"));
}

TEST(DicomDirectory, WithAnyByteChangedEndsInAListOrASentence) {
    const TemporaryFolder folder;
    folder.write("im1", slice("1.2.3", 1));
    const std::string whole = directory({"IM1"});
    int listed = 0;
    for (std::size_t at = 132; at < whole.size(); ++at)
        for (const char byte : {'\0', '\2', '\xff'}) {
            std::string changed = whole;
            changed[at] = byte;
            const auto list = listSeries(folder.write("DICOMDIR", changed));
            listed += list ? 1 : 0;
            if (!list) {
                EXPECT_FALSE(list.error().problem.empty()) << at;
            }
        }
    EXPECT_GT(listed, 0);
}

TEST(DicomDirectory, RecordsInACircleAreReadOnce) {
    const TemporaryFolder folder;
    for (const int depth : {1, 2}) folder.write("im" + std::to_string(depth), slice("1.2.3", depth));
    const std::string path = folder.write("DICOMDIR", directory({"IM1", "IM2", "IM1", "IM2"}));
    const auto list = listSeries(path);
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->series[0].files.size(), 2u);
    const std::string none = folder.write("none", directory({}));
    EXPECT_THAT(listSeries(none).error().sentence(), HasSubstr("of this DICOMDIR names no files"));
}

}  // namespace
}  // namespace echolucent
