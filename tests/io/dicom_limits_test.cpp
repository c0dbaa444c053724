// Numbers that are too large, no numbers, or too many: each is refused in a sentence, and in time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "dicom_files.h"
#include "io/dicom/dicom_file.h"
#include "io/slice_stack.h"
#include "io/study_assembly.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

TestImage slice(const Vec3& position) {
    TestImage image;
    image.pixels8.assign(12, 7);
    image.position = position;
    image.orientation = {1, 0, 0, 0, 1, 0};
    image.pixelSpacing = {0.5, 0.25};
    return image;
}

TestImage cine(int frames) {
    TestImage image;
    image.frames = frames;
    image.pixels8.assign(12 * static_cast<std::size_t>(frames), 7);
    image.pixelSpacing = {0.5, 0.25};
    return image;
}

std::string refusalOf(const std::string& path) {
    const auto study = readStudy(path);
    return study ? "was read" : study.error().sentence();
}

TEST(DicomLimits, SlicesWhoseDistanceOverflowsAreRefused) {
    // Along a tilted normal both slices of the first pair are infinitely far, and their distance is no number.
    const std::vector<std::array<Vec3, 2>> pairs{{Vec3(-1.5e308, 0, 1.5e308), Vec3(-1.6e308, 0, 1.6e308)},
                                                 {Vec3(0, 0, -1e308), Vec3(0, 0, 1e308)},
                                                 {Vec3(1e308, 1e308, 1e308), Vec3(1e308, 1e308, -1e308)},
                                                 {Vec3(0, 0, 0), Vec3(0, 0, 1e308)},
                                                 {Vec3(1e300, 0, 0), Vec3(1e300, 0, 1)}};
    for (const auto& pair : pairs)
        for (const double tilt : {0.0, 0.6}) {
            const TemporaryFolder folder;
            for (std::size_t i = 0; i < 2; ++i) {
                TestImage image = slice(pair[i]);
                image.orientation = {std::sqrt(1 - tilt * tilt), 0, tilt, 0, 1, 0};
                writeDicom(folder.file("s" + std::to_string(i)), image);
            }
            EXPECT_THAT(refusalOf(folder.path()),
                        AllOf(HasSubstr(folder.path() + "/s"), HasSubstr(": (0020,0032) Image Position"),
                              HasSubstr("no scanner")));
        }
}

TEST(DicomLimits, FramesWhoseDistanceOverflowsAreRefusedWithTheTagThatSaysSo) {
    const TemporaryFolder folder;
    TestImage offsets = cine(3);
    offsets.gridOffsets = {0, 1e308, -1e308};
    writeDicom(folder.file("offsets"), offsets);
    EXPECT_THAT(refusalOf(folder.file("offsets")), AllOf(HasSubstr("offsets: (3004,000c)"), HasSubstr("no scanner")));
    TestImage between = cine(3);
    between.spacingBetweenSlices = 1.5e308;  // twice that is infinite
    writeDicom(folder.file("between"), between);
    EXPECT_THAT(refusalOf(folder.file("between")), AllOf(HasSubstr("between: (0018,0088)"), HasSubstr("no scanner")));
    TestImage groups = cine(2);
    groups.functionalGroups = {{.position = {0, 0, -1.5e308}}, {.position = {0, 0, 1.5e308}}};
    writeDicom(folder.file("groups"), groups);
    EXPECT_THAT(refusalOf(folder.file("groups")), AllOf(HasSubstr("groups: (0020,9301)"), HasSubstr("no scanner")));
}

TEST(DicomLimits, ValuesThatAreNoNumbersOrHugeNeverBecomeAVolume) {
    for (const char* text : {"nan\\0.5", "inf\\inf", "1e308\\1e308", "1e-320\\1e-320"}) {
        const TemporaryFolder folder;
        for (int i = 0; i < 2; ++i) {
            TestImage image = slice({0, 0, 1.0 * i});
            image.pixelSpacingText = text;
            writeDicom(folder.file("s" + std::to_string(i)), image);
        }
        const auto study = readStudy(folder.path());
        if (!study)
            EXPECT_THAT(study.error().sentence(), HasSubstr("(0028,0030)")) << text;
        else
            EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << text;
    }
    for (const double huge : {1e200, 1e308, -1e308}) {
        const TemporaryFolder folder;
        for (int i = 0; i < 2; ++i) {
            TestImage image = slice({0, 0, 1.0 * i});
            image.orientation = {huge, 0, huge, 0, huge, 0};
            writeDicom(folder.file("s" + std::to_string(i)), image);
        }
        EXPECT_THAT(refusalOf(folder.path()), HasSubstr("without position and orientation")) << huge;
    }
}

TEST(DicomLimits, TimesThatAreTooFarApartAreUnknown) {
    const TemporaryFolder folder;
    TestImage image = cine(4);
    for (const double seconds : {-1.5e308, 1.5e308})
        for (const double depth : {0.0, 1.0}) image.functionalGroups.push_back({{0, 0, depth}, seconds, ""});
    writeDicom(folder.file("v"), image);
    const auto study = readStudy(folder.file("v"), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 2u);
    EXPECT_FALSE(study->phaseSeconds);
}

TEST(SliceStacks, PositionsThatAreNoNumbersAreRefused) {
    for (const double bad : {noNumber, infinite, -infinite, 1e308})
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<SlicePlane> planes(3);
            for (std::size_t i = 0; i < planes.size(); ++i) planes[i].position = Vec3(0, 0, static_cast<double>(i));
            planes[1].position[axis] = bad;
            const auto stack = stackSlices("a file", "a tag", planes);
            ASSERT_FALSE(stack) << bad << " along " << axis;
            EXPECT_THAT(stack.error().sentence(), AllOf(HasSubstr("a file"), HasSubstr("a tag")));
        }
}

TEST(StudyAssembly, AGeometryThatIsNoNumberIsRefused) {
    for (const double bad : {noNumber, infinite, -1.0, 0.0})
        for (int axis = 0; axis < 3; ++axis)
            for (const bool ofSpacing : {true, false}) {
                if (!ofSpacing && std::isfinite(bad)) continue;
                StudyParts parts;
                parts.path = "a file";
                parts.spacingSource = "a tag";
                parts.geometry.size = {2, 1, 1};
                parts.voxels.phases.emplace_back(std::vector<std::uint8_t>{1, 2});
                (ofSpacing ? parts.geometry.spacing : parts.geometry.origin)[axis] = bad;
                const auto study = assembleStudy(parts, {}, {});
                ASSERT_FALSE(study) << bad << " along " << axis;
                EXPECT_THAT(study.error().sentence(), HasSubstr("a file"));
            }
}

TEST(TextHeaders, AnOriginFartherThanAnyScannerIsRefused) {
    const TemporaryFolder folder;
    const std::string mha = folder.write(
        "v.mha",
        "NDims = 3\nDimSize = 2 1 1\nOffset = 0 1e308 0\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nvv");
    EXPECT_THAT(refusalOf(mha), HasSubstr("Offset lies farther than 10 km"));
    const std::string nrrd =
        folder.write("v.nrrd",
                     "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nspace: left-posterior-superior\n"
                     "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,-1e308)\nencoding: raw\n\nvv");
    EXPECT_THAT(refusalOf(nrrd), HasSubstr("space origin lies farther than 10 km"));
}

double secondsOf(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The bound is far above what a linear reader needs, even under a sanitizer, and far below what a quadratic one takes
/// (40 s).
constexpr double inTime = 5.0;

std::string manyValues(int count) {
    std::string text = "0.5";
    for (int i = 1; i < count; ++i) text += "\\ 0.5";
    return text;
}

TEST(DicomLimits, AnAttributeOfManyValuesIsReadInTime) {
    const TemporaryFolder folder;
    TestImage image = cine(2);
    image.spacingBetweenSlices = 1;
    image.pixelSpacing.reset();
    image.pixelSpacingText = manyValues(200000);
    image.photometric = "MONOCHROME2";
    writeDicom(folder.file("v"), image, TestSyntax::implicitLittle);  // lengths of 32 bits
    std::string refusal;
    EXPECT_LT(secondsOf([&] { refusal = refusalOf(folder.file("v")); }), inTime);
    EXPECT_THAT(refusal, HasSubstr("(0028,0030) Pixel Spacing is not two numbers above 0"));
}

TEST(DicomLimits, AsManyFrameOffsetsAsFramesAreReadInTime) {
    constexpr int frames = 200000;
    const TemporaryFolder folder;
    TestImage image = cine(frames);
    image.columns = image.rows = 1;
    image.pixels8.assign(frames, 7);
    for (int i = 0; i < frames; ++i) image.gridOffsets.push_back(0.5 * i);
    writeDicom(folder.file("v"), image, TestSyntax::implicitLittle);
    EXPECT_LT(secondsOf([&] {
                  const auto study = readStudy(folder.file("v"), withoutGuess());
                  ASSERT_TRUE(study) << study.error().sentence();
                  EXPECT_EQ(study->phases[0]->geometry().size[2], frames);
                  EXPECT_EQ(study->phases[0]->geometry().spacing[2], 0.5);
              }),
              inTime);
}

TEST(DicomLimits, CancelEndsScanAndParsing) {
    const TemporaryFolder folder;
    writeDicom(folder.file("v"), cine(2));
    std::atomic<bool> cancel{true};
    const Progress progress{{}, &cancel};
    const auto scan = scanDicom(*InputFile::open(folder.file("v")), progress);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().kind, FailureKind::cancelled);
    const auto file = DicomFile::load(folder.file("v"), false, progress);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().kind, FailureKind::cancelled);
}

}  // namespace
}  // namespace echolucent
