// The series of folders and DICOMDIRs: listed, chosen, shown small, read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <thread>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "io/dicom/series/large_stack.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A slice of 4 x 2 pixels at this depth.
std::string listedSlice(const std::string& series, int depth, const std::string& description = "", int columns = 4) {
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

std::string listedCine(const std::string& series) {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", series + ".77").text(0x0008, 0x0060, "CS", "US").text(0x0020, 0x000e, "UI", series);
    return file.picture(4, 2, 9).put(0x7fe0, 0x0010, "OW", std::string(72, 'a')).file(cineClass);
}

/// Three slices of one series, two of another, and a cine of nine frames.
void writeThreeSeries(const TemporaryFolder& folder) {
    for (const int depth : {2, 1, 3})
        folder.write("a" + std::to_string(depth), listedSlice("1.2.3", depth, "long axis"));
    for (const int depth : {1, 2}) folder.write("b" + std::to_string(depth), listedSlice("1.2.4", depth, "", 6));
    folder.write("c", listedCine("1.2.5"));
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
        folder.write("a", listedSlice("1.2.3", 1, text));
        EXPECT_EQ(listSeries(folder.path())->series[0].description, "") << text;
    }
    folder.write("a", listedSlice("1.2.3", 1, "fetal heart"));
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
    EXPECT_THAT(
        readStudy(folder.path(), options).error().sentence(),
        AllOf(HasSubstr("holds no series \"1.2.9\""),
              HasSubstr("It holds 1 (\"long axis\", 4 x 2, 3 slices), 2 (6 x 2, 2 slices), 3 (4 x 2, 9 frames). "
                        "Choose one of the numbers that info lists.")));
}

TEST(SeriesList, AListedSeriesIsReadWithoutLookingAtTheFolderAgain) {
    const TemporaryFolder folder;
    writeThreeSeries(folder);
    const auto list = listSeries(folder.path());
    folder.write("a4", listedSlice("1.2.3", 4));
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
    for (const int depth : {1, 2, 3}) folder.write("a" + std::to_string(depth), listedSlice("1.2.3", depth));
    for (const int depth : {1, 2}) folder.write("b" + std::to_string(depth), listedSlice("1.2.3", depth, "", 6));
    folder.write("c", listedCine("1.2.3"));
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
    folder.write("a", listedSlice("1.2.3", 1) + volume.bytes());
    folder.write("b", listedSlice("1.2.3", 2));
    DicomBytes settings;
    settings.text(0x7fe1, 0x0010, "LO", "KRETZ_US").put(0x7fe1, 0x1001, "OB", "settings, no volume ");
    folder.write("c", listedSlice("1.2.5", 3) + settings.bytes());
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 3u);
    EXPECT_FALSE(list->series[0].whyNot);
    EXPECT_EQ(list->series[0].files[0].path, folder.file("a"));
    for (const std::size_t i : {1, 2})
        EXPECT_THAT(list->series[i].whyNot->sentence(), HasSubstr("is a single 2D picture"))
            << "no volume stands there";
}

TEST(SeriesList, TheMiddlePictureIsSmall) {
    const TemporaryFolder folder;
    for (const int depth : {1, 2, 3}) {
        std::string bytes = listedSlice("1.2.3", depth, "", 40);
        // Slice n is dark but for its n-th four columns of ten.
        for (int pixel = 0; pixel < 80; ++pixel)
            if (pixel % 40 / 4 != depth) bytes[bytes.size() - 80 + static_cast<std::size_t>(pixel)] = '\0';
        folder.write(std::to_string(9 - depth), bytes);
    }
    const auto list = listSeries(folder.path());
    const auto picture = middlePicture(list->series[0], 10);
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->width, 10);
    EXPECT_EQ(picture->height, 1);
    EXPECT_EQ(picture->grey, (std::vector<std::uint8_t>{0, 0, 255, 0, 0, 0, 0, 0, 0, 0})) << "of the second slice";
}

TEST(SeriesList, APictureOfHundredsOfMillionsOfPixelsIsNotMadeSmall) {
    const TemporaryFolder folder;
    DicomBytes file;
    const std::string path = folder.write("q", file.picture(65535, 65535, 2)
                                                   .put(0x3001, 0x1001, "UL", bytesFrom<std::uint32_t>({2}))
                                                   .put(0x7fe0, 0x0010, "OW", "12345678")
                                                   .file("1.2.840.113543.6.6.1.3.10002"));
    std::filesystem::resize_file(path, std::uintmax_t{2} * 65535 * 65535 + 1000);  // which takes no space on disc
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    const auto picture = middlePicture(list->series[0], 10);
    ASSERT_FALSE(picture);
    EXPECT_THAT(picture.error().sentence(), HasSubstr("65535 x 65535 pixels, which are not shown small"));
}

TEST(SeriesList, SaysWhatItDidNotLookAt) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("1/2/3/4/deep"));
    for (const char* name : {"a", "1/2/3/4/b", "1/2/3/4/deep/c"}) folder.write(name, listedSlice("1.2.3", name[0] % 7));
    folder.write("d.dcm.gz", deflated(listedSlice("1.2.3", 9), 31));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->files.size(), 2u);
    EXPECT_THAT(list->warnings,
                ElementsAre(HasSubstr("1 folder(s) deeper than 4 were not looked into, \"deep\" among them."),
                            HasSubstr("1 file(s) are packed with gzip and were not looked into, \"d.dcm.gz\"")));
    writeThreeSeries(folder);
    std::filesystem::remove_all(folder.file("1/2/3/4/deep"));
    std::filesystem::remove(folder.file("d.dcm.gz"));
    EXPECT_THAT(listSeries(folder.path())->warnings, ElementsAre());
}

TEST(SeriesList, SaysWhichSeriesWasRead) {
    const TemporaryFolder folder;
    writeThreeSeries(folder);
    EXPECT_TRUE(warnsOf(*readStudy(folder.path(), withoutGuess()),
                        "There are 3 series here; that of 4 x 2, 3 slices was read."));
    ReadOptions options = withoutGuess();
    options.series = "1.2.5";
    options.framesAsSlices = true;
    EXPECT_TRUE(warnsOf(*readStudy(folder.path(), options), "that of 4 x 2, 9 frames was read."));
}

TEST(SeriesList, NotesOfAllSlicesAreKept) {
    const TemporaryFolder folder;
    for (const int depth : {1, 2, 3})
        folder.write("a" + std::to_string(depth),
                     listedSlice("1.2.3", depth) + (depth > 1 ? std::string(40, 'x') : ""));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_TRUE(warnsOf(*study, "What stands behind the pixels is no DICOM; it is left out. (Said of 2 of 3 slices.)"));
}

TEST(SeriesList, RescalingInTheGroupsOfSingleFramesIsSeen) {
    const TemporaryFolder folder;
    for (const int depth : {0, 1}) {
        DicomBytes transformation, file;
        transformation.text(0x0028, 0x1052, "DS", "1").text(0x0028, 0x1053, "DS", depth == 0 ? "1" : "2");
        if (depth == 0) transformation = DicomBytes().text(0x0028, 0x1053, "DS", "1");
        file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth));
        file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").picture(2, 1, 0);
        file.sequence(0x5200, 0x9229, {DicomBytes().sequence(0x0028, 0x9145, {transformation})});
        folder.write("s" + std::to_string(depth), file.put(0x7fe0, 0x0010, "OW", "\3\4").file(pictureClass));
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{3, 4, 7, 9}));
}

TEST(SeriesList, SlicesOfUnknownPixelSizeKeepTheirDistance) {
    const TemporaryFolder folder;
    for (const int depth : {0, 3}) folder.write("a" + std::to_string(depth), listedSlice("1.2.3", depth));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(3, 3, 3));
    EXPECT_TRUE(warnsOf(*study, "as the slices are apart, 3 mm"));
}

TEST(SeriesList, TheLargest2DRegionGivesThePixelSizeOfSlicesToo) {
    const TemporaryFolder folder;
    const auto region = [](int width, double centimetres, std::uint16_t format) {
        DicomBytes item;
        item.word(0x0018, 0x6012, format).put(0x0018, 0x6018, "UL", bytesFrom<std::uint32_t>({0}));
        item.put(0x0018, 0x601a, "UL", bytesFrom<std::uint32_t>({0}));
        item.put(0x0018, 0x601c, "UL", bytesFrom<std::uint32_t>({static_cast<std::uint32_t>(width)}));
        item.put(0x0018, 0x601e, "UL", bytesFrom<std::uint32_t>({2})).word(0x0018, 0x6024, 3).word(0x0018, 0x6026, 3);
        return item.real(0x0018, 0x602c, centimetres).real(0x0018, 0x602e, centimetres);
    };
    for (const int depth : {0, 1}) {
        DicomBytes file;
        file.sequence(0x0018, 0x6011, {region(3, 0.9, 2), region(1, 0.5, 1), region(3, 0.02, 1)});
        file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth));
        file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").picture(4, 2, 0);
        folder.write("s" + std::to_string(depth), file.put(0x7fe0, 0x0010, "OW", "12345678").file(pictureClass));
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.2, 0.2, 1)) << "neither an M-mode nor the first region";
}

TEST(LargeStack, RunsOnNoMoreThreadsThanItIsGiven) {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    int pieces = 0;
    runEachWithLargeStack(50, 1,
                          [&](std::size_t) {
                              const std::lock_guard lock(mutex);
                              threads.insert(std::this_thread::get_id());
                              ++pieces;
                          },
                          {});
    EXPECT_EQ(threads.size(), 1u);
    EXPECT_EQ(pieces, 50);
}

TEST(SeriesList, SaysWhyItIsEmpty) {
    const TemporaryFolder folder;
    EXPECT_THAT(listSeries(folder.path()).error().sentence(), HasSubstr("is a folder without DICOM images"));
    folder.write("a", listedSlice("1.2.3", 1).substr(0, 400));
    EXPECT_THAT(listSeries(folder.path()).error().sentence(), HasSubstr("/a: "));
}

TEST(SeriesList, CancelEndsItWithinAFileAThread) {
    const TemporaryFolder folder;
    for (int i = 0; i < 200; ++i) folder.write(std::to_string(i), listedSlice("1.2.3", i));
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

TEST(DicomDirectory, OpensAsTheFilesThatItNames) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("images/series"));
    for (const int depth : {1, 2, 3})
        folder.write("images/series/im" + std::to_string(depth), listedSlice("1.2.3", depth));
    for (const int depth : {1, 2, 3, 4}) folder.write("other" + std::to_string(depth), listedSlice("1.2.4", depth));
    const std::string path = folder.write("DICOMDIR", dicomDirectory({"IMAGES\\SERIES\\IM1", "IMAGES\\SERIES\\IM2",
                                                                      "IMAGES\\SERIES\\IM3", "IMAGES\\GONE"}));
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
    folder.write("secret", listedSlice("1.2.3", 1));
    const std::string path =
        folder.write("in/DICOMDIR", dicomDirectory({"..\\SECRET", folder.file("secret"), "/etc/passwd",
                                                    "IN\\..\\..\\SECRET", "", "A\\\\B", std::string(200, 'X')}));
    const auto list = listSeries(path);
    ASSERT_FALSE(list);
    EXPECT_THAT(list.error().sentence(),
                HasSubstr("is a DICOMDIR, and none of the 6 files that it names is in its folder or below it"));
    EXPECT_THAT(readStudy(path).error().sentence(), HasSubstr("is a DICOMDIR"));
}

TEST(DicomDirectory, WithAnyByteChangedEndsInAListOrASentence) {
    const TemporaryFolder folder;
    folder.write("im1", listedSlice("1.2.3", 1));
    const std::string whole = dicomDirectory({"IM1"});
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
    for (const int depth : {1, 2}) folder.write("im" + std::to_string(depth), listedSlice("1.2.3", depth));
    const std::string path = folder.write("DICOMDIR", dicomDirectory({"IM1", "IM2", "IM1", "IM2"}));
    const auto list = listSeries(path);
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->series[0].files.size(), 2u);
    const std::string none = folder.write("none", dicomDirectory({}));
    EXPECT_THAT(listSeries(none).error().sentence(), HasSubstr("of this DICOMDIR names no files"));
}

}  // namespace
}  // namespace echolucent
