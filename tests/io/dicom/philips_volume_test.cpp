// Philips's own ways to keep a volume in DICOM, written byte by byte.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string qlab = "1.2.840.113543.6.6.1.3.10002";

/// What a QLAB file may say falsely.
struct Qlab {
    int frames = 2;
    std::uint32_t slices = 4;
    double sliceSpacing = 0.05;
    double pixelSpacing = 0.02;
    std::int64_t declared = -1;    ///< length of Pixel Data; the true one where it is below 0
    std::size_t held = 2 * 24;     ///< bytes of Pixel Data
    std::string frameTime = "40";  ///< ms; none if empty
    std::string frameTimes{};      ///< Frame Time Vector
    std::string cineRate{};        ///< a second
};

/// Volumes of 3 x 2 x 4 voxels that count up from 1.
std::string qlabFile(const Qlab& said) {
    DicomBytes file;
    if (!said.cineRate.empty()) file.text(0x0018, 0x0040, "IS", said.cineRate);
    if (!said.frameTime.empty()) file.text(0x0018, 0x1063, "DS", said.frameTime);
    if (!said.frameTimes.empty()) file.text(0x0018, 0x1065, "DS", said.frameTimes);
    file.word(0x0018, 0x6024, 3).word(0x0018, 0x6026, 3);
    file.real(0x0018, 0x602c, said.pixelSpacing).real(0x0018, 0x602e, 2 * said.pixelSpacing);
    file.picture(3, 2, said.frames).put(0x3001, 0x1001, "UL", bytesFrom<std::uint32_t>({said.slices}));
    file.real(0x3001, 0x1003, said.sliceSpacing);
    std::string voxels;
    for (std::size_t i = 0; i < said.held; ++i) voxels += static_cast<char>(i + 1);
    return file.put(0x7fe0, 0x0010, "OW", voxels, said.declared).file(qlab);
}

Result<Study> readQlab(const Qlab& said, const ReadOptions& options = withoutGuess()) {
    const TemporaryFolder folder;
    return readStudy(folder.write("q.dcm", qlabFile(said)), options);
}

std::string qlabRefusal(const Qlab& said) {
    const auto study = readQlab(said);
    return study ? "was read" : study.error().sentence();
}

TEST(QlabCartesian, GivesAllVolumesWithTheirSpacing) {
    const auto study = readQlab({});
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 2u);
    const VolumeGeometry& geometry = study->phases[1]->geometry();
    EXPECT_EQ(geometry.size, (std::array<std::int64_t, 3>{3, 2, 4}));
    EXPECT_LT(length(geometry.spacing - Vec3(0.2, 0.4, 0.5)), 1e-12);
    EXPECT_TRUE(geometry.spacingKnown);
    EXPECT_DOUBLE_EQ(*study->phaseTimes.meanSeconds, 0.04);
    EXPECT_EQ(study->phases[1]->storedValue(0), 25);
    EXPECT_EQ(study->phases[1]->storedValue(23), 48);
    EXPECT_THAT(factOf(*study, "format"), HasSubstr("Philips QLAB Cartesian"));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 255);
}

TEST(QlabCartesian, AFalseLengthOfItsPixelsIsSaidAndNotFollowed) {
    for (const std::int64_t declared : {96911360LL, 12LL}) {
        const auto study = readQlab({.declared = declared});
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases.size(), 2u);
        EXPECT_TRUE(warnsOf(*study, "declares " + std::to_string(declared) + " bytes, the file holds 48"));
    }
}

TEST(QlabCartesian, VolumesThatAreNotThereAreSaid) {
    const auto study = readQlab({.frames = 30, .held = 2 * 24 + 11});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 2u);
    EXPECT_TRUE(warnsOf(*study, "declares 30 volumes and holds 2"));
}

TEST(QlabCartesian, TheEndOfTheLastRowMayBeMissingAndIsNoData) {
    const auto study = readQlab({.held = 2 * 24 - 2});
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 2u);
    const Volume& last = *study->phases[1];
    EXPECT_TRUE(last.hasData(21));
    EXPECT_FALSE(last.hasData(22));
    EXPECT_FALSE(last.hasData(23));
    EXPECT_TRUE(warnsOf(*study, "ends 2 bytes early"));
}

TEST(QlabCartesian, TheTimesOfVolumesAreThoseOfFrames) {
    const auto study = readQlab({.frames = 4, .held = 3 * 24, .frameTimes = "0\\20\\60\\20"});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phaseTimes.starts, (std::vector<double>{0, 0.02, 0.08})) << "of the three that are there";
    EXPECT_TRUE(warnsOf(*study, "uneven"));
    const auto secondsOf = [](const Qlab& said) { return readQlab(said)->phaseTimes.meanSeconds.value_or(0); };
    EXPECT_DOUBLE_EQ(secondsOf({.frameTimes = "0\\20\\60"}), 0.04) << "a vector of other frames";
    EXPECT_DOUBLE_EQ(secondsOf({.frameTimes = "0\\-20"}), 0.04);
    EXPECT_DOUBLE_EQ(secondsOf({.frameTime = "", .frameTimes = "0\\25"}), 0.025);
    EXPECT_DOUBLE_EQ(secondsOf({.frameTime = "0", .cineRate = "20"}), 0.05);
    EXPECT_DOUBLE_EQ(secondsOf({.frameTime = ""}), 0);
}

TEST(QlabCartesian, ASpacingThatUltrasoundCannotHaveIsAGuessInMm) {
    const auto study = readQlab({.sliceSpacing = 30, .pixelSpacing = 0.5});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_LT(length(study->phases[0]->geometry().spacing - Vec3(0.5, 1, 30)), 1e-12);
    EXPECT_TRUE(warnsOf(*study, "taken as mm"));
}

TEST(QlabCartesian, NumbersThatMakeNoSenseAreRefusedOrUnknown) {
    EXPECT_THAT(qlabRefusal({.slices = 0}), HasSubstr("(3001,1001) Number of Slices is missing or not above 0"));
    EXPECT_THAT(qlabRefusal({.slices = 0xffffffff}),
                HasSubstr("(7fe0,0010) Pixel Data holds 48 bytes where one volume"));
    EXPECT_THAT(qlabRefusal({.held = 20}), HasSubstr("holds 20 bytes where one volume of 3 x 2 x 4 voxels needs 24"));
    EXPECT_THAT(qlabRefusal({.frames = -1}), HasSubstr("was read")) << "without the attribute it is one volume";
    for (const double bad : {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const auto study = readQlab({.sliceSpacing = bad});
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << bad;
    }
}

TEST(QlabCartesian, IsRefusedWhereItsPixelsAreNotPlain) {
    const TemporaryFolder folder;
    const std::string plain = qlabFile({});
    const std::string header = DicomBytes().file(qlab), body = plain.substr(header.size());
    const std::string deflatedFile = DicomBytes().file(qlab, deflatedSyntax) + deflated(body, -15);
    const std::string encapsulated = DicomBytes().file(qlab, jpegLosslessSyntax) + body;
    ASSERT_TRUE(readStudy(folder.write("plain", header + body), withoutGuess()));
    for (const std::string& bytes : {deflatedFile, encapsulated}) {
        const auto study = readStudy(folder.write("q.dcm", bytes), withoutGuess());
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(), HasSubstr("is absent, deflated or compressed"));
    }
}

TEST(QlabCartesian, TheMiddlePictureOfALargeOneIsItsMiddleSlice) {
    const TemporaryFolder folder;
    folder.write("q.dcm", qlabFile({}));
    const auto list = listSeries(folder.path());
    const auto picture = middlePicture(list->series[0], 100);
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->grey.front(), std::lround(255 * 13.0 / 18)) << "slice 3 of the first phase: 13 to 18";
    // A slice whose last row is cut.
    folder.write("q.dcm", qlabFile({.frames = 1, .slices = 1, .held = 5}));
    const auto cut = middlePicture(listSeries(folder.path())->series[0], 100);
    ASSERT_TRUE(cut) << cut.error().sentence();
    EXPECT_EQ(cut->grey.front(), 51);
}

TEST(QlabCartesian, IsListedAsAVolume) {
    const TemporaryFolder folder;
    folder.write("q.dcm", qlabFile({}));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->series[0].size, (std::array<std::int64_t, 3>{3, 2, 4}));
    EXPECT_FALSE(list->series[0].whyNot);
    const auto study = readSeries(*list, list->series[0]);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 2u);
    const auto picture = middlePicture(list->series[0], 100);
    ASSERT_TRUE(picture) << picture.error().sentence();
    EXPECT_EQ(picture->width, 3);
    EXPECT_EQ(picture->grey.back(), 255);
}

/// A scanner's file with `frames` frames of 3 x 2 pixels; `voxels` stand in a private element unless they are empty.
std::string scannerFile(const std::string& size, int frames, const std::string& voxels, const std::string& vr = "LO") {
    DicomBytes file;
    file.picture(3, 2, frames);
    if (!voxels.empty()) file.text(0x200d, 0x0030, "LO", "Philips US Imaging DD 033");
    file.text(0x200d, 0x0031, "LO", "Philips US Imaging DD 036");
    if (!voxels.empty()) file.put(0x200d, 0x300b, "OB", voxels);
    file.text(0x200d, 0x3101, vr, size).text(0x200d, 0x3103, vr, "0.15\\0.12\\0.33");
    std::string pixels;
    for (int i = 0; i < 6 * frames; ++i) pixels += static_cast<char>(i + 1);
    return file.put(0x7fe0, 0x0010, "OW", pixels).file(cineClass);
}

Result<Study> readScanner(const std::string& bytes) {
    const TemporaryFolder folder;
    return readStudy(folder.write("s.dcm", bytes), withoutGuess());
}

TEST(PhilipsScanner, FramesAreSlicesWhereThePrivateElementsSaySo) {
    for (const char* vr : {"LO", "UN"}) {
        const auto study = readScanner(scannerFile("3\\2\\4", 4, "", vr));
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{3, 2, 4}));
        EXPECT_LT(length(study->phases[0]->geometry().spacing - Vec3(0.15, 0.12, 0.33)), 1e-12);
        EXPECT_TRUE(study->phases[0]->geometry().spacingKnown);
        EXPECT_EQ(study->phases[0]->storedValue(23), 24);
    }
}

TEST(PhilipsScanner, FramesOfSeveralVolumesArePhases) {
    const auto study = readScanner(scannerFile("3\\2\\2", 4, ""));
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 2u);
    EXPECT_EQ(study->phases[1]->storedValue(0), 13);
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
}

TEST(PhilipsScanner, PlainVoxelsOfAPrivateElementAreRead) {
    const auto study = readScanner(scannerFile("2\\2\\3", 2, "abcdefghijkl"));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{2, 2, 3}));
    EXPECT_EQ(study->phases[0]->storedValue(0), 'a');
    EXPECT_EQ(study->phases[0]->storedValue(11), 'l');
}

TEST(PhilipsScanner, AVolumeInTheMakersOwnCodingIsRefusedByThatName) {
    for (const char* size : {"416\\412\\256", "100000\\100000\\100000"}) {
        const auto study = readScanner(scannerFile(size, 4, "compressed!!"));
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(),
                    AllOf(HasSubstr("(200d,3101) declares a 3D volume"), HasSubstr("Philips's own coding")));
        EXPECT_TRUE(study.error().framesCouldBeSlices);
        EXPECT_THAT(study.error().remedy, HasSubstr("--frames-as-slices"));
    }
}

TEST(PhilipsScanner, ThePicturesBesideAVolumeInTheMakersOwnCodingCanBeSlices) {
    const TemporaryFolder folder;
    ReadOptions options = withoutGuess();
    options.framesAsSlices = true;
    const auto study = readStudy(folder.write("s.dcm", scannerFile("416\\412\\256", 4, "compressed!!")), options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{3, 2, 4}));
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(study->phases[0]->storedValue(23), 24);
}

TEST(PhilipsScanner, TheReportNamesWhatGaveTypeAndTime) {
    const auto study = readScanner(scannerFile("2\\2\\3", 2, "abcdefghijkl"));
    ASSERT_TRUE(study) << study.error().sentence();
    const auto sourceOf = [&](const Study& one, const std::string& name) {
        for (const ImportFact& fact : one.facts)
            if (fact.name == name) return fact.source;
        return std::string("none");
    };
    EXPECT_THAT(sourceOf(*study, "voxel type"), HasSubstr("(200d,300b)"));
    EXPECT_EQ(sourceOf(*readScanner(scannerFile("3\\2\\2", 4, "")), "time between phases"), "the file does not say it");
}

TEST(PhilipsScanner, TheMiddlePictureIsTheMiddleSliceAlone) {
    for (const auto& [size, voxels, last] :
         std::vector<std::tuple<std::string, std::string, int>>{{"3\\2\\4", "", 6}, {"2\\2\\3", "abcdefghijkl", 4}}) {
        const TemporaryFolder folder;
        folder.write("s.dcm", scannerFile(size, 4, voxels));
        const auto list = listSeries(folder.path());
        ASSERT_TRUE(list) << list.error().sentence();
        const auto picture = middlePicture(list->series[0], 100);
        ASSERT_TRUE(picture) << picture.error().sentence();
        ASSERT_EQ(picture->grey.size(), static_cast<std::size_t>(last));
        // Voxels count up: the first of the slice against its last tells which slice it is.
        const double first = voxels.empty() ? 13.0 / 18 : double('e') / 'h';
        EXPECT_EQ(picture->grey.front(), std::lround(255 * first));
    }
}

TEST(PhilipsScanner, NonsenseInThePrivateElementsLeavesACine) {
    for (const char* size : {"", "3\\2", "3\\2\\nan", "0\\2\\4", "-3\\2\\4", "3\\2\\1e300", "3.5\\2\\4", "3\\2\\1"}) {
        const auto study = readScanner(scannerFile(size, 4, ""));
        ASSERT_FALSE(study) << size;
        EXPECT_THAT(study.error().sentence(), HasSubstr("is a 2D cine")) << size;
    }
}

}  // namespace
}  // namespace echolucent
