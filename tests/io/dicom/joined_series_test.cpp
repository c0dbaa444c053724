// Volumes whose slices each have a series of their own, and folders that gained or lost something on their way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A picture with a series of its own.
struct LoneSlice {
    int number = 0;
    double depth = 0;
    std::string series{}, study = "1.2.7", frame = "1.2.9", orientation = "1\\0\\0\\0\\1\\0", patient = "P-1";
    std::string imageType{}, echoTime{}, trigger{}, description = "3D volume";
    std::uint16_t columns = 4;
    int value = 0;

    [[nodiscard]] std::string bytes() const {
        DicomBytes file;
        if (!imageType.empty()) file.text(0x0008, 0x0008, "CS", imageType);
        file.text(0x0008, 0x0018, "UI", "1.2.3.1." + std::to_string(number)).text(0x0008, 0x103e, "LO", description);
        file.text(0x0010, 0x0020, "LO", patient);
        if (!echoTime.empty()) file.text(0x0018, 0x0081, "DS", echoTime);
        if (!trigger.empty()) file.text(0x0018, 0x1060, "DS", trigger);
        file.text(0x0020, 0x000d, "UI", study).text(0x0020, 0x000e, "UI", series);
        file.text(0x0020, 0x0013, "IS", "1").text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth));
        file.text(0x0020, 0x0037, "DS", orientation).text(0x0020, 0x0052, "UI", frame);
        file.text(0x0028, 0x0030, "DS", "0.5\\0.5");
        DicomBytes pixels;
        pixels.picture(columns, 2, 0);
        pixels.put(0x7fe0, 0x0010, "OW", std::string(static_cast<std::size_t>(2 * columns), static_cast<char>(value)));
        return file.file(pictureClass) + pixels.bytes();
    }
};

/// Writes `count` pictures 2 mm apart, each in its series, after `set` has changed each. Values are 1 + the number.
void writeLone(const TemporaryFolder& folder, int count, const std::function<void(LoneSlice&)>& set) {
    for (int number = 0; number < count; ++number) {
        LoneSlice slice;
        slice.number = number;
        slice.depth = 2.0 * number;
        slice.value = 1 + number;
        slice.series = "1.2.3." + std::to_string(100 - number);
        set(slice);
        folder.write("i" + std::to_string(number), slice.bytes());
    }
}

TEST(JoinedSeries, PicturesThatLieSideBySideAreOneVolume) {
    const TemporaryFolder folder;
    writeLone(folder, 5, [](LoneSlice&) {});
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 1u);
    EXPECT_EQ(list->series[0].uid, "1.2.3.100")
        << "the series of the first slice names it, whatever its file is called";
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases[0];
    ASSERT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{4, 2, 5}));
    EXPECT_EQ(volume.geometry().spacing, Vec3(0.5, 0.5, 2));
    for (std::int64_t slice = 0; slice < 5; ++slice)
        EXPECT_EQ(volume.storedValue(8 * slice), static_cast<double>(1 + slice));
    EXPECT_TRUE(warnsOf(*study, "5 series of one place each lie side by side and were joined to one volume."));
    ReadOptions options = withoutGuess();
    options.series = "1.2.3.100";
    EXPECT_TRUE(readStudy(folder.path(), options)) << "a document names it so";
}

TEST(JoinedSeries, WhatDoesNotBelongTogetherStaysAlone) {
    const std::vector<std::pair<const char*, std::function<void(LoneSlice&)>>> strangers{
        {"orientation", [](LoneSlice& slice) { slice.orientation = "1\\0\\0\\0\\0\\-1"; }},
        {"frame of reference", [](LoneSlice& slice) { slice.frame = "1.2.10"; }},
        {"patient", [](LoneSlice& slice) { slice.patient = "P-2"; }},
        {"study", [](LoneSlice& slice) { slice.study = "1.2.71"; }},
        {"size", [](LoneSlice& slice) { slice.columns = 6; }},
        {"contrast", [](LoneSlice& slice) { slice.echoTime = "90"; }},
        {"localizer", [](LoneSlice& slice) { slice.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER"; }},
    };
    for (const auto& stranger : strangers) {
        const auto& what = stranger.first;
        const TemporaryFolder folder;
        writeLone(folder, 5, [&](LoneSlice& slice) {
            if (slice.number == 4) stranger.second(slice);
        });
        const auto list = listSeries(folder.path());
        ASSERT_TRUE(list) << list.error().sentence();
        ASSERT_EQ(list->series.size(), 2u) << what;
        EXPECT_FALSE(list->series[0].whyNot) << what;
        EXPECT_EQ(list->series[0].size[2], 4) << what;
        EXPECT_EQ(list->series[1].files[0].path, folder.file("i4")) << what;
    }
}

TEST(JoinedSeries, StandsBehindASeriesThatOpensByItself) {
    const TemporaryFolder folder;
    writeLone(folder, 5, [](LoneSlice&) {});
    for (int number = 10; number < 13; ++number) {
        LoneSlice slice;
        slice.number = slice.value = number;
        slice.depth = number;
        slice.series = "1.2.3.500";
        folder.write("v" + std::to_string(number), slice.bytes());
    }
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 2u);
    EXPECT_EQ(list->series[0].uid, "1.2.3.500");
    EXPECT_EQ(list->series[1].size[2], 5);
    EXPECT_FALSE(list->series[1].whyNot);
}

TEST(JoinedSeries, EachWithAFrameOfReferenceOfItsOwnIsNotJoined) {
    const TemporaryFolder folder;
    writeLone(folder, 4, [](LoneSlice& slice) { slice.frame = "1.2.9." + std::to_string(slice.number); });
    EXPECT_EQ(listSeries(folder.path())->series.size(), 4u);
}

TEST(JoinedSeries, AMissingSliceIsSaid) {
    const TemporaryFolder folder;
    writeLone(folder, 5, [](LoneSlice&) {});
    std::filesystem::remove(folder.file("i2"));
    EXPECT_THAT(readStudy(folder.path()).error().sentence(),
                HasSubstr("puts slices between 2 and 4 mm apart; slices are missing or uneven"));
}

TEST(JoinedSeries, ACineOfEachPlaceIsAVolumeOverTime) {
    const TemporaryFolder folder;
    writeLone(folder, 12, [](LoneSlice& slice) {
        const int place = slice.number / 4, phase = slice.number % 4;
        slice.series = "1.2.3." + std::to_string(place);
        slice.depth = 2.0 * place;
        slice.trigger = std::to_string(40 * phase + place);
        slice.value = 1 + 10 * phase + place;
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 4u);
    EXPECT_EQ(study->phases[2]->storedValue(8), 22);
    EXPECT_TRUE(warnsOf(*study, "3 series of one place each"));
}

std::string directorySlice(int depth) {
    LoneSlice slice;
    slice.number = depth;
    slice.depth = depth;
    slice.series = "1.2.3";
    slice.value = 1 + depth;
    return slice.bytes();
}

TEST(DicomDirectory, FindsFilesThatGainedOrLostAnEnding) {
    const std::vector<std::array<std::string, 2>> spellings{{"IM", ".dcm"}, {"im", ".DCM"}, {"im", ".dicom"},
                                                            {"im", ";1"},   {"im", ".;1"},  {"IM", ".img"}};
    for (const auto& [name, ending] : spellings) {
        const TemporaryFolder folder;
        std::filesystem::create_directories(folder.file("images"));
        for (const int depth : {0, 1, 2})
            folder.write("images/" + name + "000" + std::to_string(depth) + ending, directorySlice(depth));
        folder.write("images/im0001.txt", "a note on this picture");
        const std::string path =
            folder.write("dicomdir", dicomDirectory({"IMAGES\\IM0000", "IMAGES\\IM0001", "IMAGES\\IM0002"}));
        const auto study = readStudy(path, withoutGuess());
        ASSERT_TRUE(study) << ending << study.error().sentence();
        EXPECT_EQ(study->phases[0]->geometry().size[2], 3) << ending;
        EXPECT_EQ(warnsOf(*study, "3 of 3 files that the DICOMDIR names have another ending here"),
                  ending.find(';') == std::string::npos)
            << ending;
    }
    const TemporaryFolder folder;
    for (const int depth : {0, 1, 2}) folder.write("1.2." + std::to_string(depth), directorySlice(depth));
    const std::string path = folder.write("DICOMDIR.dcm", dicomDirectory({"1.2.0.DCM", "1.2.1.DCM", "1.2.2", "1.2"}));
    const auto study = readStudy(path, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 3);
    EXPECT_TRUE(warnsOf(*study, "1 of 4 files that the DICOMDIR names are not in its folder")) << "1.2 is not 1.2.0";
}

TEST(DicomDirectory, SaysWhatHelpsIfItsFilesLieElsewhere) {
    const TemporaryFolder folder;
    for (const int depth : {0, 1, 2}) folder.write("slice" + std::to_string(depth), directorySlice(depth));
    const std::string path = folder.write("DICOMDIR", dicomDirectory({"IMAGES\\IM0000"}));
    EXPECT_THAT(readStudy(path).error().sentence(),
                AllOf(HasSubstr("none of the 1 files that it names is in its folder or below it. 3 other DICOM file(s) "
                                "are: \"slice0\", \"slice1\", \"slice2\""),
                      HasSubstr("Open the folder itself")));
}

TEST(FolderOfSeries, LinksThatLeadNowhereOrOutAreNamedAndNotFollowed) {
    const TemporaryFolder folder, elsewhere;
    for (const int depth : {0, 1, 2, 3}) folder.write("s" + std::to_string(depth), directorySlice(depth));
    elsewhere.write("s4", directorySlice(4));
    std::filesystem::create_symlink(elsewhere.file("s4"), folder.file("s4"));
    std::filesystem::create_symlink("gone", folder.file("s5"));
    std::filesystem::create_directory_symlink(elsewhere.path(), folder.file("more"));
    std::filesystem::create_directory_symlink(".", folder.file("self"));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 4);
    EXPECT_TRUE(warnsOf(*study, "1 link(s) lead to files out of the folder and were not followed, \"s4\" among them."));
    EXPECT_TRUE(warnsOf(*study, "1 link(s) lead to folders out of this one and were not followed, \"more\""));
    EXPECT_TRUE(warnsOf(*study, "1 link(s) lead nowhere, \"s5\" among them."));
    // If a slice is missing for it, the refusal says so.
    std::filesystem::remove(folder.file("s2"));
    EXPECT_THAT(
        readStudy(folder.path()).error().sentence(),
        AllOf(HasSubstr("slices are missing or uneven"), HasSubstr("1 link(s) lead nowhere, \"s5\" among them")));
}

TEST(FolderOfSeries, NamesInAnyScriptAndOfAnyBytesAreReadAndNamed) {
    const TemporaryFolder folder;
    const std::string longest = std::string(251, 'n') + ".dcm";
    const std::vector<std::string> names{"Простата 1", "心エコー.dcm", "a\nb\x1b[31m", "\xff\xfe", longest, "50% %1"};
    for (std::size_t i = 0; i < names.size(); ++i) folder.write(names[i], directorySlice(static_cast<int>(i)));
    folder.write("心エコー (copy).dcm", directorySlice(1));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 6);
    EXPECT_TRUE(warnsOf(*study, "left out: \"心エコー (copy).dcm\"."));
}

}  // namespace
}  // namespace echolucent
